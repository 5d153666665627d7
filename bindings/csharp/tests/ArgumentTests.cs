// Arguments that C cannot receive are refused with a message that names them, as the library does.
using System;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    private static void Says(string expected, Action action)
    {
        string said;
        try { said = Refused(action).Message; }
        catch (ArgumentException error) { said = error.Message; }
        Check(said.Contains(expected), "\"" + said + "\", expected \"" + expected + "\"");
    }

    private static void ScenesWithoutDocumentAreRefused()
    {
        Says("name is null, expected the name of a built-in scene", () => MimoScene.Builtin(null));
        Says("path is null, expected the path of an MJCF file", () => MimoScene.FromFile(null));
        Says("xml is null, expected MJCF text", () => MimoScene.FromXml(null));
        Says("name is \"\", expected the name of a built-in scene", () => MimoScene.Builtin(""));
        Says("path is \"\", expected the path of an MJCF file", () => MimoScene.FromFile(""));
        Says("xml is \"\", expected MJCF text", () => MimoScene.FromXml(""));
        Says("scene_name is \"\"", () => new Env(""));
        Says("scene is null", () => new Env((MimoScene)null));
        Says("scene is null", () => new Batch(null, 2));
    }

    /// <summary>A task needs an agent. A room may be empty, with a message.</summary>
    private static void TasksNeedAgents()
    {
        const string expected = "task \"reach\" is for agents, and the scene has none; MimoScene.AddAgents adds its infants";
        using (var scene = MimoScene.Builtin("reach"))
        {
            Says(expected, () => new Env(scene));
            Says(expected, () => new Batch(scene, 2));
            Check(scene.AddAgents(scene.DefaultAgent()) == 1, "one infant");
            using (var env = new Env(scene)) Check(env.Layout.Agents == 1, "agents");
        }
        string told = null;
        using (var scene = MimoScene.Builtin("benchmark"))
        using (new Env(scene, new EnvConfig { Log = record => told = record.Text }))
            Check(told != null && told.Contains("\"benchmark\" has no agents") && told.Contains("MimoScene.AddAgents"), told);
    }

    private static void NegativeNumbersAreRefused()
    {
        using (var batch = new Batch(ReachScene(), 2, autoreset: Autoreset.None, threads: 1))
        using (var scene = ReachScene())
        using (var env = new Env("reach"))
        {
            Says("worlds is -1", () => new Batch(scene, -1));
            Says("threads is -1", () => new Batch(scene, 1, threads: -1));
            Says("world is -1", () => batch.World(-1));
            Says("world is -1", () => batch.ErrorOf(-1));
            Says("world is 2, but there are 2", () => batch.StepOf(2));
            Says("agent is 1, but there are 1", () => batch.StepOf(0, 1));
            Says("world is -1", () => batch.WasReset(-1));
            Says("world is -1", () => batch.HasFinal(-1));
            Says("agent is -1", () => env.Agent(-1));
            Says("agent is 1, but there are 1", () => env.StepOf(1));
            Says("agent is -1", () => env.Gaze(-1));
            Says("agent is -1", () => env.LookAt(new Vector3d(1, 0, 0), Look.Eyes, -1));
            Says("count is -1", () => env.StepPhysics(-1));
            Says("segments is -4", () => env.Mesh(0, Axes.Mimo, -4));
            Says("element is -1", () => env.Layout.Fields[0].Label(-1));
            Says("agent is -1", () => scene.LimitSense("touch", agent: -1));
            Says("agent is -1", () => scene.SetTouch(-1, null, 0));
            Says("count is -1", () => scene.SetSources(-1, 1));
        }
    }

    private static void NullsAreRefused()
    {
        using (var scene = ReachScene())
        using (var env = new Env("reach"))
        {
            var field = env.Layout.Fields[0];
            Says("values is null", () => env.Get(Quantity.JointPosition, null, (double[])null));
            Says("values is null", () => env.Get(Quantity.JointPosition, null, (float[])null));
            Says("values is null", () => env.Set(Quantity.JointPosition, null, null));
            Says("values is null", () => env.Random(null));
            Says("positions is null", () => env.Follow(null));
            Says("samples is null", () => env.Play("head", null, 16000));
            Says("state is null", () => env.Load(null));
            Says("poses is null", () => env.Poses(Kind.Body, Axes.Unity, null));
            Says("config is null", () => env.Draw(null, new byte[4]));
            Says("points is null", () => env.Project(new PictureConfig(), null));
            Says("field is null", () => env.Read(null, new float[1]));
            Says("into is null", () => env.Read(field, (float[])null));
            Says("picture is null", () => env.ReadRgba(null, new byte[4]));
            Says("points is null", () => Frames.ConvertPoints(Axes.Unity, null));
            Says("config is null", () => scene.AddObject(null));
            Says("config is null", () => scene.AddCamera(null));
            Says("env is null", () => new Recorder(null, "x.h5"));
            Says("env is null", () => new PoseReader(null));
        }
    }

    /// <summary>The message names an array that is too short, its length and the length that is needed.</summary>
    private static void ShortArraysAreNamed()
    {
        using (var env = new Env("reach"))
        {
            var position = env.Layout.Find("proprioception/position");
            var count = position.Shape[0];
            Says("into is Single[3], but proprioception/position has " + count + " elements of type F32",
                () => env.Read(position, new float[3]));
            Says("into is Double[" + count + "], but proprioception/position", () => env.Read(position, new double[count]));
            Says("directions is Single[4], expected 3 numbers for each", () => Frames.ConvertDirections(Axes.Unity, new float[4]));
            Says("value_count is 1", () => env.Get(Quantity.JointPosition, null, new double[1]));
        }
        using (var env = new Env("benchmark"))
        {
            var eye = env.Layout.Find("vision/eye_left");
            Says("rgba is Byte[5], but vision/eye_left needs 4 bytes for each of 256 x 256 pixels", () => env.ReadRgba(eye, new byte[5]));
        }
        using (var batch = new Batch(ReachScene(), 2))
        {
            Says("seeds is UInt64[1], expected one for each of 2 worlds", () => batch.Reset(new ulong[1]));
            Says("autoreset is not SameStep", () => batch.ReadFinal(0, batch.Layout.Fields[0], new float[9]));
        }
    }
}
