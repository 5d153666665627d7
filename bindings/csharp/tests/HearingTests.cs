using System;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    private static Env Listening(Action<MimoScene> change = null)
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            change?.Invoke(scene);
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Touch = 0;
            agent.Hearing = Hearing.Ears;
            agent.Voice = true;
            scene.AddAgent(agent);
            return new Env(scene);
        }
    }

    /// <summary>A cry has 82 dB at 1 m and 99 dB at the infant's own ears: docs/guide/hearing.md. 0 dB is 20
    /// micropascals.</summary>
    private static void InfantsHearTheirOwnVoice()
    {
        using (var env = Listening())
        {
            var actions = env.Layout.Actions;
            var voice = actions.Count - 4;
            Check(actions.Skip(voice).Select(action => action.Name).SequenceEqual(
                new[] { "voice:loudness", "voice:pitch", "voice:opening", "voice:front" }), actions[voice].Name);
            var cry = new float[actions.Count];
            cry[voice] = cry[voice + 2] = cry[voice + 3] = 1;
            var ear = env.Layout.Find("hearing/ear_left");
            var heard = new float[ear.Shape[0]];
            var squares = 0.0;
            env.Reset(1);
            for (var step = 0; step < 50; ++step)
            {
                env.Step(cry);
                env.Read(ear, heard);
                if (step >= 25) squares += heard.Sum(pressure => (double)pressure * pressure);
            }
            Near(99, 10 * Math.Log10(squares / (25 * heard.Length) / 4e-10), 1, "the level of a cry");
        }
    }

    private static void InfantsHearWhatIsPlayed()
    {
        using (var env = Listening())
        {
            var ear = env.Layout.Find("hearing/ear_right");
            var heard = new float[ear.Shape[0]];
            env.Reset(1);
            env.Play("head", Enumerable.Range(0, 800).Select(i => (float)Math.Sin(0.3 * i)).ToArray(), ear.SampleRate);
            env.Step(null);
            env.Read(ear, heard);
            Check(heard.Max() > 0.1f, "nothing is heard: " + heard.Max());
            var error = Refused(() => env.Play("head", new float[10], 44100));
            Check(error.Message.StartsWith("rate is 44100, expected 16000"), error.Message);
        }
    }

    /// <summary>The loudest pressure in half a second of a tone that the head plays from a place in its
    /// frame.</summary>
    private static float PeakFrom(Vector3d place)
    {
        using (var env = Listening(scene => scene.DirectSource("head", place, new Vector3d(0, 0, -1), 0)))
        {
            var ear = env.Layout.Find("hearing/ear_right");
            var heard = new float[ear.Shape[0]];
            var peak = 0f;
            env.Reset(1);
            env.Play("head", Enumerable.Range(0, 8000).Select(i => (float)Math.Sin(0.3 * i)).ToArray(), ear.SampleRate);
            for (var step = 0; step < 50; ++step)
            {
                env.Step(null);
                env.Read(ear, heard);
                peak = Math.Max(peak, heard.Max());
            }
            return peak;
        }
    }

    /// <summary>Sound pressure falls with the distance: half at twice the distance.</summary>
    private static void SoundsComeFromTheirPlace()
    {
        Near(2, PeakFrom(new Vector3d(0, 0, 2)) / PeakFrom(new Vector3d(0, 0, 4)), 0.1, "pressure at 2 m over that at 4 m");
        using (var scene = MimoScene.Builtin("free"))
            Says("directivity is 2", () => scene.DirectSource("head", new Vector3d(), new Vector3d(0, 0, 1), 2));
    }
}
