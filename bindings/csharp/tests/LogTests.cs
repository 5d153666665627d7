// Log messages: their contents, their world, and the lifetime of the delegate.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Mimo;

internal static partial class Tests
{
    // A box on a plane has four contacts, and there is room for one: MuJoCo warns.
    private const string Crowded = "<mujoco><size nconmax='1'/><worldbody><geom type='plane' size='1 1 1'/>" +
        "<body pos='0 0 0.05'><freejoint/><geom type='box' size='0.1 0.1 0.1'/></body></worldbody></mujoco>";

    /// <summary>The box falls by 1 cm: g h^2 n (n + 1) / 2 with h = 2 ms, so 23 physics steps, or 46 ms.</summary>
    private static void LogDropsExceptions()
    {
        var records = new List<LogRecord>();
        var options = new EnvConfig { Log = record => { records.Add(record); throw new Exception("stays"); } };
        using (var scene = MimoScene.FromXml(Crowded.Replace("0.05", "0.11")))
        using (var env = new Env(scene, options))
        {
            options.Log = null;
            GC.Collect();
            GC.WaitForPendingFinalizers();
            while (env.Time < 0.1) env.Step(null);
            var told = records.Single();
            Check(told.Level == LogLevel.Warning && told.Code == WarningCode.ContactsDropped, "another warning");
            Check(told.Text.Contains("nconmax") && told.World == 0, told.Text);
            Near(0.048, told.Time, 0.0021, "time");
        }
    }

    /// <summary>A clone still logs after the original world is destroyed.</summary>
    private static void ClonesShareTheLog()
    {
        var records = new List<LogRecord>();
        Env clone;
        using (var scene = MimoScene.FromXml(Crowded))
        using (var env = new Env(scene, new EnvConfig { Log = records.Add })) clone = env.Clone();
        GC.Collect();
        GC.WaitForPendingFinalizers();
        clone.Step(null);
        clone.Dispose();
        Check(records.Count > 0, "no warning");
    }

    private static void LogNamesTheWorldOfABatch()
    {
        var worlds = new HashSet<int?>();
        using (var scene = MimoScene.FromXml(Crowded))
        using (var batch = new Batch(scene, 3, new EnvConfig { Log = record => worlds.Add(record.World) }))
        {
            worlds.Clear();
            batch.Reset();
            Check(worlds.SetEquals(new int?[] { 0, 1, 2 }), string.Join(" ", worlds));
        }
    }

    /// <summary>An infant that starts within a box of 1 m.</summary>
    private static void ScenesLog()
    {
        var records = new List<LogRecord>();
        using (var scene = MimoScene.Empty(new SceneConfig { Log = records.Add }))
        {
            scene.AddObject(new ObjectConfig { Name = "block", Shape = Shape.Box, Size = new Vector3d(0.5, 0.5, 0.5), Fixed = true });
            var agent = scene.DefaultAgent();
            agent.Vision = Vision.None;
            agent.Touch = MimoTouch.None;
            agent.Place = Place.Lowest;
            scene.AddAgent(agent);
            GC.Collect();
            new Env(scene).Dispose();
            var told = records.Single(record => record.Text.Contains("block"));
            Check(told.Level == LogLevel.Warning && told.World == null && told.Time == 0, told.Text);
        }
    }

    /// <summary>Runs on its own thread, so that no stack refers to the delegate.</summary>
    private static void DisposedObjectsReleaseTheLog()
    {
        WeakReference records = null;
        var thread = new Thread(() => records = LogAndDispose());
        thread.Start();
        thread.Join();
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        Check(!records.IsAlive, "still referenced");
    }

    private static WeakReference LogAndDispose()
    {
        var records = new List<LogRecord>();
        using (var scene = MimoScene.FromXml(Crowded, new SceneConfig { Log = records.Add }))
        using (var env = new Env(scene, new EnvConfig { Log = records.Add }))
        using (env.Clone())
        using (var batch = new Batch(scene, 2, new EnvConfig { Log = records.Add }))
        {
            Refused(() => new Env(scene, new EnvConfig { Log = records.Add, Samples = 3 }));
            Refused(() => MimoScene.Builtin("bench", new SceneConfig { Log = records.Add }));
            batch.Step(null);
        }
        return new WeakReference(records);
    }
}
