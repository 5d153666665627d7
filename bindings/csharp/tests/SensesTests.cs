using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using Mimo;

internal static partial class Tests
{
#if WINDOWS
    private const string MuJoCo = "mujoco-2.2.2";
#else
    private const string MuJoCo = "libmujoco.so.2.2.2";
#endif

    [DllImport(MuJoCo)] private static extern int mj_version();
    [DllImport(MuJoCo)] private static extern IntPtr mj_loadXML(byte[] file, IntPtr files, byte[] error, int length);
    [DllImport(MuJoCo)] private static extern IntPtr mj_makeData(IntPtr model);
    [DllImport(MuJoCo)] private static extern void mj_forward(IntPtr model, IntPtr data);
    [DllImport(MuJoCo)] private static extern void mj_step(IntPtr model, IntPtr data);
    [DllImport(MuJoCo)] private static extern void mj_deleteData(IntPtr data);
    [DllImport(MuJoCo)] private static extern void mj_deleteModel(IntPtr model);

    /// <summary>The left arm gets half of its commands, two steps of 10 ms late.</summary>
    private static void MotorsAreLimited()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Touch = 0;
            scene.AddAgent(agent);
            scene.LimitMotor("left_arm", gain: 0.5, delay: 0.02);
            using (var env = new Env(scene))
            {
                var action = Enumerable.Repeat(0.5f, env.Layout.Actions.Count).ToArray();
                var told = new double[2];
                var ids = new[] { env.Find(Kind.Actuator, "act:left_elbow"), env.Find(Kind.Actuator, "act:right_elbow") };
                for (var step = 0; step < 3; ++step)
                {
                    env.Step(action);
                    env.Get(Quantity.ActuatorControl, ids, told);
                    Near(step < 2 ? 0 : 0.25, told[0], 1e-7, "the left arm in step " + step);
                    Near(0.5, told[1], 1e-7, "the right arm");
                }
            }
        }
    }

    private static void NoiseFollowsFromTheSeed(Senses senses, IntPtr data, Field position)
    {
        Func<ulong, float[]> seen = seed =>
        {
            var values = new float[position.Shape[0]];
            senses.Reset(data, seed);
            senses.Observe(data);
            senses.Read(position, values);
            return values;
        };
        var first = seen(5);
        Check(!first.SequenceEqual(seen(6)) && first.SequenceEqual(seen(5)), "noise of another seed");
    }

    /// <summary>Senses on a host's MuJoCo, with a delay of five steps, and their memory as bytes.</summary>
    private static void SensesRemember()
    {
        IntPtr model = mj_loadXML(Encoding.UTF8.GetBytes("tests/models/humanoid.xml\0"), IntPtr.Zero, new byte[500], 500);
        Check(model != IntPtr.Zero, "no model");
        IntPtr data = mj_makeData(model);
        mj_forward(model, data);
        using (var scene = MimoScene.Empty())
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Vestibular = 0;
            agent.Touch = 0;
            agent.Body = "scene";
            agent.Root = "torso";
            scene.AddAgent(agent);
            scene.LimitSense("proprioception/position", delay: 0.05);
            scene.LimitSense("proprioception/velocity", noise: 0.01, delay: 0.05); // new noise in every step
            var options = new SensesConfig { Step = 0.01 };
            using (Senses senses = new Senses(scene, model, mj_version(), options), twin = new Senses(scene, model, mj_version(), options))
            {
                var position = senses.Layout.Find("proprioception/position");
                float[] first = new float[position.Shape[0]], now = new float[first.Length];
                senses.Reset(data, 5);
                senses.Observe(data);
                senses.Read(position, first);
                for (var step = 0; step < 6; ++step)
                {
                    if (step == 5) Check(twin.Load(senses.Save()).Fresh.Count == 0, "something started fresh");
                    mj_step(model, data);
                    foreach (var each in new[] { senses, twin })
                    {
                        each.Advance(data);
                        each.Observe(data);
                    }
                    senses.Read(position, now);
                    Check(first.SequenceEqual(now) == step < 5, "another delay than five steps: step " + step);
                }
                Check(senses.Block.SequenceEqual(twin.Block), "the twin remembers something else");
                Check(Refused(() => senses.Load(new byte[3])).Message.Contains("state"), "another message");
                NoiseFollowsFromTheSeed(senses, data, senses.Layout.Find("proprioception/velocity"));
            }
            Check(Refused(() => new Senses(scene, model, 237)).Message.Contains("mujoco_version"), "another message");
        }
        mj_deleteData(data);
        mj_deleteModel(model);
    }

    /// <summary>A height field with more triangles than the ray renderer can draw (24 floats each, 2^31 of them):
    /// OSMesa draws it if it is installed.</summary>
    private static void SensesLogTheirRenderer()
    {
        const string hills = "<mujoco><asset><hfield name='hills' nrow='7000' ncol='7000' size='1 1 1 1'/></asset><worldbody>" +
            "<geom type='hfield' hfield='hills'/><camera name='above' pos='0 0 2'/></worldbody></mujoco>";
        var file = Path.GetTempFileName();
        File.WriteAllText(file, hills);
        var model = mj_loadXML(Encoding.UTF8.GetBytes(file + "\0"), IntPtr.Zero, new byte[500], 500);
        File.Delete(file);
        Check(model != IntPtr.Zero, "no model");
        var records = new List<LogRecord>();
        using (var scene = MimoScene.Empty())
        {
            scene.AddCamera(new CameraConfig { Name = "above", Width = 8, Height = 8 });
            Action attach = () => new Senses(scene, model, mj_version(), new SensesConfig { Log = records.Add }).Dispose();
#if WINDOWS
            var refused = Refused(attach);
            Check(refused.Status == Status.Unsupported && refused.Message.Contains("too large for the ray renderer"), refused.Message);
#else
            attach();
            var told = records.Single();
            Check(told.Level == LogLevel.Info && told.World == null && told.Text.Contains("OSMesa"), told.Text);
#endif
        }
        mj_deleteModel(model);
    }
}
