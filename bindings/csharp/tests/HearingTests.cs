using System;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    private static Env Listening()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Touch = 0;
            agent.Hearing = Hearing.Ears;
            agent.Voice = true;
            scene.AddAgent(agent);
            return new Env(scene);
        }
    }

    /// <summary>A cry is 82 dB at 1 m, 99 at the own ears: docs/guide/hearing.md. 0 dB are 20 micropascals.</summary>
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
}
