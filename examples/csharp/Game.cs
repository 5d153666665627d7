// The loop of a game: steps an infant at 60 Hz, reads the picture of its left eye for a texture, and its body's poses in the
// engine's frame.
//
//   mcs -r:MimoSharp.dll Game.cs && mono Game.exe [SECONDS]
using System;
using System.Diagnostics;
using System.Globalization;
using System.Threading;
using Mimo;

internal static class Game
{
    private const double FrameSeconds = 1.0 / 60;

    private static Env MakeInfant()
    {
        using (var scene = MimoScene.Builtin("benchmark"))
        {
            var agent = scene.DefaultAgent();
            agent.VisionWidth = agent.VisionHeight = 64;
            scene.AddAgent(agent);
            return new Env(scene);
        }
    }

    /// <summary>Steps the world until it reaches the clock. A step takes 10 ms, a frame 16.7 ms.</summary>
    private static void CatchUp(Env env, float[] action, double clock)
    {
        while (env.Time < clock)
        {
            for (var i = 0; i < action.Length; ++i) action[i] = (float)Math.Sin(3 * env.Time + i);
            env.Step(action);
        }
    }

    private static int Main(string[] arguments)
    {
        var seconds = arguments.Length > 0 ? double.Parse(arguments[0], CultureInfo.InvariantCulture) : 2;
        using (var env = MakeInfant())
        {
            var eye = env.Layout.Find("vision/eye_left");
            var texture = new byte[eye.Shape[0] * eye.Shape[1] * 4];
            var poses = new PoseReader(env);
            var action = new float[env.Layout.Actions.Count];
            var frames = (int)Math.Round(seconds / FrameSeconds);
            double longest = 0, sum = 0;
            env.Reset(1);
            for (var frame = 1; frame <= frames; ++frame)
            {
                var watch = Stopwatch.StartNew();
                CatchUp(env, action, frame * FrameSeconds);
                env.ReadRgba(eye, texture, bottomUp: true);
                poses.Read();
                var spent = watch.Elapsed.TotalSeconds;
                sum += spent;
                if (frame > 10) longest = Math.Max(longest, spent); // in the first frames the runtime compiles
                if (spent < FrameSeconds) Thread.Sleep(TimeSpan.FromSeconds(FrameSeconds - spent));
            }
            var head = poses.Poses[env.Find(Kind.Body, "head")];
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                "{0} frames: {1:F2} ms each, {2:F2} ms at most, of {3:F1}; the head is {4:F2} m above the ground",
                frames, 1000 * sum / frames, 1000 * longest, 1000 * FrameSeconds, head.Y));
            return 0;
        }
    }
}
