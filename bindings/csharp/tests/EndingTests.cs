// Worlds that are never disposed: their domain is unloaded, as in Unity's editor before it runs changed scripts, or their
// process ends.
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Mimo;

internal static partial class Tests
{
    private sealed class CountingTask : MimoTask
    {
        public override void Evaluate(Env world, TaskMoment moment, TaskVerdict verdict)
        {
            world.Get(Quantity.WorldGravity);
            verdict.Reward = moment.Step;
        }
    }

    /// <summary>The scripts of a game, which keep all their objects in static fields and dispose nothing.</summary>
    private sealed class Scripts : MarshalByRefObject
    {
        private static readonly List<IDisposable> kept = new List<IDisposable>();

        /// <summary>One infant with proprioception.</summary>
        private static MimoScene Room()
        {
            var scene = MimoScene.Builtin("free");
            var infant = scene.DefaultAgent();
            infant.Vision = 0;
            infant.Touch = 0;
            scene.AddAgent(infant);
            return scene;
        }

        /// <summary>Makes worlds of each kind in the middle of their work. Writes a recording of five steps into the
        /// file.</summary>
        public void Play(string file)
        {
            var scene = Room();
            var recorded = new Env(scene);
            kept.Add(new Recorder(recorded, file, new RecorderConfig { Replace = true }));
            for (var step = 0; step < 5; ++step) recorded.Step(null);
            scene.SetTask(new CountingTask());
            var moving = new Env(scene);
            Forever(() => moving.Step(null));
            var stepped = new Batch(scene, 4, threads: 2);
            Forever(() => stepped.Step(null));
            var sent = new Batch(scene, 4, threads: 2);
            sent.Reset();
            for (var step = 1; step < 5; ++step) sent.Step(null);
            Check(sent.Rewards[3] == 4, "the reward of the fourth step");
            sent.Send(null);
            kept.AddRange(new IDisposable[] { scene, recorded, moving, stepped, sent });
            Attach();
        }

        private static void Attach()
        {
            var model = mj_loadXML(Encoding.UTF8.GetBytes("tests/models/humanoid.xml\0"), IntPtr.Zero, new byte[500], 500);
            Check(model != IntPtr.Zero, "no model");
            var data = mj_makeData(model);
            mj_forward(model, data);
            var scene = MimoScene.Empty();
            var body = scene.DefaultAgent();
            body.Vision = 0;
            body.Vestibular = 0;
            body.Touch = 0;
            body.Body = "scene";
            body.Root = "torso";
            scene.AddAgent(body);
            var senses = new Senses(scene, model, mj_version());
            senses.Reset(data);
            senses.Observe(data);
            kept.Add(senses);
        }

        private static void Forever(Action action)
        {
            var began = new ManualResetEvent(false);
            new Thread(() =>
            {
                for (action(); ; action()) began.Set();
            }) { IsBackground = true }.Start();
            Check(began.WaitOne(60000), "no step in a minute");
        }
    }

    /// <summary>20 times: play, then reload with all objects alive.</summary>
    private static void DomainsReloadWithLiveObjects()
    {
        if (Type.GetType("Mono.Runtime") == null) return; // .NET Core has a single domain, which cannot be unloaded
        var file = Path.GetTempFileName();
        var done = new ManualResetEvent(false);
        Exception failure = null;
        var editor = new Thread(() =>
        {
            try
            {
                for (var reload = 0; reload < 20; ++reload) PlayAndReload(file);
            }
            catch (Exception error) { failure = error; }
            done.Set();
        }) { IsBackground = true };
        editor.Start();
        Check(done.WaitOne(300000), "20 reloads take more than 5 minutes");
        if (failure != null) throw failure;
        File.Delete(file);
    }

    private static void PlayAndReload(string file)
    {
        var domain = AppDomain.CreateDomain("scripts");
        var scripts = (Scripts)domain.CreateInstanceAndUnwrap(typeof(Scripts).Assembly.FullName, typeof(Scripts).FullName);
        scripts.Play(file);
        AppDomain.Unload(domain);
        IsWhole(file);
    }

    /// <summary>Two states: the one before the first step, and the last one, which closing adds.</summary>
    private static void IsWhole(string file)
    {
        using (var recording = new Recording(file))
            Check(recording.Info.Steps == 5 && recording.Info.States == 2, "steps and states of the recording");
    }

    /// <summary>Tests.exe --end FILE: a program that ends with all objects alive. Tests.exe --ended FILE: checks its
    /// recording.</summary>
    private static int AtTheEnd(string what, string file)
    {
        if (what == "--end") new Scripts().Play(file);
        else IsWhole(file);
        Console.WriteLine("all is well"); // a thread that fails later changes the exit status
        return 0;
    }
}
