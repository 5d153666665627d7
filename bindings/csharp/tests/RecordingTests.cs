// Recordings of a program's run, and their replay to the last bit.
using System;
using System.IO;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    private static void RecordingsReplayIdentically()
    {
        var path = Path.GetTempFileName();
        using (var env = Listening())
        using (var twin = Listening())
        {
            var action = Enumerable.Repeat(0.3f, env.Layout.Actions.Count).ToArray();
            var heard = new float[env.Layout.Find("hearing/ear_left").Shape[0]];
            var options = new RecorderConfig
            {
                Keep = "hearing/ear_left", StateSeconds = 0.1, Configuration = "{}", Seed = 7
            };
            using (var recorder = new Recorder(env, path, options))
            {
                env.Play("head", Enumerable.Range(0, 320).Select(i => (float)Math.Sin(0.3 * i)).ToArray(), 16000);
                for (var i = 0; i < 5; ++i) env.Step(action);
                env.Reset(3, Growth.OfAge(3));
                for (var i = 0; i < 5; ++i) env.Step(action);
                env.Step(null);
                env.Read(env.Layout.Find("hearing/ear_left"), heard);
                recorder.Flush();
                recorder.Close();
            }
            using (var recording = new Recording(path))
            {
                var info = recording.Info;
                Check(info.Steps == 11 && info.Bodies == 2 && info.SameBuild, "info");
                Check(info.Configuration == "{}" && info.Seed == "7", info.Configuration);
                Says("no replay has begun: call Recording.Seek first", () => recording.Step(twin));
                Check(recording.Seek(twin) == 0, "seek");
                recording.Step(twin);
                var report = recording.Play(twin);
                Check(report.Identical && report.Steps == 11 && report.DiffersMostIn == "", report.DiffersMostIn);
                Check(twin.Get(Quantity.AgentAge)[0] == 3, "age");
                using (var alone = recording.CreateEnv())
                {
                    recording.Seek(alone);
                    Check(recording.Play(alone).Identical, "the file alone");
                }
                var kept = recording.Read<float>("fields/hearing/ear_left", 10, 1);
                Check(kept.SequenceEqual(heard), "another sound");
                Check(recording.Read<float>("fields/hearing/ear_left", 0, 5).Max() > 0.1f, "silence");
                Check(recording.Rows("time") == 11, "rows");
                Check(recording.Read<double>("time", 10, 1)[0] == 0.11, "time");
                var error = Refused(() => recording.Read<double>("time", 10, 2));
                Check(error.Message.Contains("11 rows"), error.Message);
            }
        }
        File.Delete(path);
    }

    private static void OtherFilesAreRefused()
    {
        var path = Path.GetTempFileName();
        Check(Refused(() => new Recording(path)).Message.Contains("is not a recording"), "an empty file");
        using (var env = Listening())
        using (new Recorder(env, path))
        {
            Check(Refused(() => new Recorder(env, path)).Message.Contains("already"), "two recorders");
            env.Step(null);
        }
        using (var recording = new Recording(path)) Check(recording.Info.Steps == 1, "steps");
        using (var env = Listening())
        {
            var error = Refused(() => new Recorder(env, path));
            Check(error.Message.Contains("only if `replace` is set"), error.Message);
            using (new Recorder(env, path, new RecorderConfig { Replace = true }))
            {
                env.Step(null);
                env.Step(null);
            }
        }
        using (var recording = new Recording(path)) Check(recording.Info.Steps == 2, "replaced");
        File.Delete(path);
    }
}
