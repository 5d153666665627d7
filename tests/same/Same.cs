// The scenario of tests/capi/same.c, which gives the same hashes in every language.
using System;
using System.Collections.Generic;
using System.Globalization;
using Mimo;

internal static class Same
{
    private static ulong HashOf(ulong hash, byte[] bytes) // FNV-1a
    {
        unchecked
        {
            foreach (var b in bytes) hash = (hash ^ b) * 1099511628211;
        }
        return hash;
    }

    /// <summary>The task "own" of tests/capi/same.c.</summary>
    private sealed class Height : MimoTask
    {
        public override int Memory => 1;
        public override IReadOnlyList<string> Terms => new[] { "height", "effort" };
        public override IReadOnlyList<TaskField> Fields => new[]
        {
            new TaskField("desired_goal") { Unit = "m", Frame = "world" }, new TaskField("achieved_goal") { Unit = "m", Frame = "world" }
        };

        public override void Reset(Env world, TaskMoment moment)
        {
            world.Random(moment.Memory);
            moment.Memory[0] = 0.2 + 0.2 * moment.Memory[0];
            moment.Fields[0] = (float)moment.Memory[0];
        }

        public override void Evaluate(Env world, TaskMoment moment, TaskVerdict verdict)
        {
            var place = new double[3];
            world.Get(Quantity.BodyPosition, new[] { world.Find(Kind.Body, "left_hand") }, place);
            double effort = 0;
            foreach (var action in moment.Action) effort += (double)action * action;
            verdict.Terms[0] = place[2] - moment.Memory[0];
            verdict.Terms[1] = -0.01 * effort;
            moment.Fields[1] = (float)place[2];
            verdict.Outcome = place[2] > moment.Memory[0] ? Outcome.Success : Outcome.None;
            verdict.GoesOn = true;
        }
    }

    private static Env Make(string name)
    {
        if (name != "own") return new Env(name);
        using (var scene = MimoScene.Builtin("benchmark"))
        {
            var infant = scene.DefaultAgent();
            infant.Vision = 0;
            scene.AddAgent(infant);
            scene.SetTask(new Height());
            return new Env(scene);
        }
    }

    private static void Run(string scene)
    {
        using (var env = Make(scene))
        {
            var action = new float[env.Layout.Actions.Count];
            env.Reset(7);
            var hash = HashOf(14695981039346656037, env.Block);
            double sum = 0;
            for (var step = 0; step < 100; ++step)
            {
                for (var i = 0; i < action.Length; ++i) action[i] = ((7 * step + 3 * i) % 21 - 10) / 10.0f;
                sum += env.Step(action).Reward;
                hash = HashOf(hash, env.Block);
            }
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0} {1:x16} {2:F6}", scene, hash, sum));
        }
    }

    private static byte[] BytesOf(Array numbers)
    {
        var bytes = new byte[Buffer.ByteLength(numbers)];
        Buffer.BlockCopy(numbers, 0, bytes, 0, bytes.Length);
        return bytes;
    }

    /// <summary>The picture of tests/capi/same.c.</summary>
    private static void DrawStage()
    {
        var config = new StageConfig
        {
            Geoms = new StageShapes
            {
                ObjectType = 5, Forms = new[] { (int)Form.Plane, (int)Form.Sphere }, Sizes = new[] { 0, 0, 0, 0.5, 0, 0 },
                Colors = new[] { 1, 1, 1, 1, 0.9f, 0.2f, 0.1f, 1 }, Materials = new[] { 0, -1 }
            },
            Textures = new StageTextures
            {
                Types = new[] { (int)TextureType.Flat }, Widths = new[] { 2 }, Heights = new[] { 2 }, Srgb = new byte[] { 1 },
                Pixels = new byte[] { 200, 30, 90, 20, 180, 60, 40, 80, 220, 250, 240, 130 }
            },
            Materials = new StageMaterials { Colors = new[] { 1f, 1f, 1f, 1f }, Textures = new[] { 0 } },
            Lights = new StageLights { Types = new[] { (int)Lamp.Sun } }
        };
        var upright = new double[] { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
        var poses = new StagePoses
        {
            GeomPositions = new[] { 0, 0, 0, 0, 0, 0.5 }, GeomRotations = new double[] { 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1 },
            LightPositions = new double[] { 0, 0, 5 }, LightDirections = new[] { 0, 0.6, -0.8 }
        };
        var view = new StageView { Width = 64, Height = 48, Position = new double[] { 0, 0, 4 }, Rotation = upright };
        using (var stage = new Stage(config))
        {
            var picture = stage.Draw(poses, view);
            var hash = HashOf(14695981039346656037, picture.Rgb);
            hash = HashOf(HashOf(hash, BytesOf(picture.Depth)), BytesOf(picture.Segmentation));
            double sum = 0;
            foreach (var level in picture.Rgb) sum += level;
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "stage {0:x16} {1:F6}", hash, sum));
        }
    }

    private static void Main()
    {
        foreach (var scene in new[] { "reach", "standup", "selfbody", "benchmark", "own" }) Run(scene);
        DrawStage();
    }
}
