// Steps of worlds and batches, reward terms, timing, and pictures.
using System;
using System.Linq;
using System.Runtime.CompilerServices;
using Mimo;

internal static partial class Tests
{
    /// <summary>A ball at a height of 2 m in an empty world.</summary>
    private static Env Ball(EnvConfig options = null)
    {
        using (var scene = MimoScene.Empty())
        {
            scene.AddObject(new ObjectConfig { Name = "ball", Position = new Vector3d(0, 0, 2) });
            return new Env(scene, options);
        }
    }

    /// <summary>The paper's tasks take steps of 10 ms, two of 5 ms each (docs/tasks.md).</summary>
    private static void WorldsDescribeTaskAndTimeSteps()
    {
        using (var env = new Env("reach"))
            Check(env.Task == "reach" && env.FrameSkip == 2 && env.Timestep == 0.005, env.Task + " of other steps");
        using (var env = Ball(new EnvConfig { FrameSkip = 3 }))
        {
            Check(env.Task == "none" && env.FrameSkip == 3, "three");
            env.Step(null);
            Near(0.015, env.Time, 1e-15, "three steps of 5 ms");
        }
    }

    /// <summary>Semi-implicit Euler with h = 5 ms: after n steps a ball has fallen by g h^2 n (n + 1) / 2.</summary>
    private static void BarePhysicsStepsAreCounted()
    {
        using (var env = Ball())
        {
            env.StepPhysics(6);
            env.StepPhysics();
            env.StepPhysics(0);
            var joint = new double[7];
            env.Get(Quantity.JointPosition, new[] { 0 }, joint);
            Near(2 - 9.81 * 0.005 * 0.005 * 28, joint[2], 1e-12, "height");
            Check(Refused(() => env.StepPhysics(1000001)).Message.Contains("count is 1000001"), "another message");
        }
    }

    /// <summary>Without gravity a ball stays at its place; without contacts two overlapping balls do not touch; both
    /// Jacobians give the same bounce.</summary>
    private static void PartsOfPhysicsAreLeftOut()
    {
        Func<Env, double> height = env =>
        {
            var joint = new double[7];
            env.Get(Quantity.JointPosition, new[] { 0 }, joint);
            return joint[2];
        };
        using (var env = Ball(new EnvConfig { Disable = Disable.Gravity }))
        {
            env.StepPhysics(20);
            Check(height(env) == 2, "falls without gravity");
        }
        using (var scene = MimoScene.Empty())
        {
            scene.AddObject(new ObjectConfig { Name = "ball", Position = new Vector3d(0, 0, 2) });
            scene.AddObject(new ObjectConfig { Name = "post", Position = new Vector3d(0, 0, 1.95), Fixed = true });
            Func<EnvConfig, int> contacts = options =>
            {
                using (var env = new Env(scene, options))
                {
                    env.StepPhysics();
                    return env.Count(Kind.Contact);
                }
            };
            Check(contacts(new EnvConfig()) == 1 && contacts(new EnvConfig { Disable = Disable.Contact }) == 0, "contacts");
            Check(contacts(new EnvConfig { Disable = Disable.Contact | Disable.OwnSolver }) == 0, "both");
            using (Env dense = new Env(scene, new EnvConfig { Jacobian = Jacobian.Dense }),
                sparse = new Env(scene, new EnvConfig { Jacobian = Jacobian.Sparse }))
            {
                dense.StepPhysics(20);
                sparse.StepPhysics(20);
                Near(height(dense), height(sparse), 1e-9, "height");
                Check(height(dense) > 2, "not pushed out");
            }
            using (var env = new Env(scene))
            {
                Says("set step_contacts in EnvConfig", () => env.StepContacts());
                Says("has no Quantity.Now; Env.Observe computes", () => env.Get(Quantity.ActuatorForce | Quantity.Now));
            }
            Check(Refused(() => new Env(scene, new EnvConfig { Jacobian = (Jacobian)7 })).Message.Contains("jacobian is 7"), "Jacobian");
            Check(Refused(() => new Env(scene, new EnvConfig { Disable = (Disable)0x80 })).Message.Contains("disable"), "bits");
        }
    }

    /// <summary>In reach the term "distance" is that of the right fingers and the ball, and the reward is the sum of
    /// all terms (docs/tasks.md).</summary>
    private static void RewardsAreSumsOfTerms()
    {
        using (var env = new Env("reach"))
        {
            env.Reset(3);
            var reward = env.Step(null).Reward;
            Check(env.Layout.Terms.Count == 2 && env.Terms.Sum() == reward, "the reward is their sum");
            Check(env.Terms[env.Layout.FindTerm("success")] == 0, "rewarded from afar");
            var at = new double[6];
            env.Get(Quantity.BodyPosition, new[] { env.Find(Kind.Body, "right_fingers"), env.Find(Kind.Body, "target") }, at);
            var distance = Math.Sqrt(Enumerable.Range(0, 3).Sum(i => Math.Pow(at[i] - at[3 + i], 2)));
            Check(distance > 0.1, "there already");
            Near(-distance, env.Terms[env.Layout.FindTerm("distance")], 1e-12, "distance");
            try { env.Layout.FindTerm("distance", 1); }
            catch (ArgumentException error)
            {
                Check(error.Message.Contains("\"distance\" of agent 1") && error.Message.Contains("success of 0"), error.Message);
                return;
            }
            throw new Exception("there is one agent");
        }
    }

    private static void TimingAddsUp()
    {
        using (var scene = MimoScene.Builtin("reach"))
        {
            scene.AddAgent(scene.DefaultAgent());
            using (Env silent = new Env(scene), env = new Env(scene, new EnvConfig { Timing = true }))
            {
                for (var i = 0; i < 3; ++i)
                {
                    env.Step(null);
                    silent.Step(null);
                }
                var spent = env.Timing;
                Check(spent.Steps == 3 && spent.Physics > 0 && spent.Proprioception > 0, "not counted");
                Check(spent.Physics + spent.Proprioception < spent.Total && spent.Touch == 0 && spent.Vision == 0, "reach has neither");
                env.ResetTiming();
                Check(env.Timing.Equals(new Timing()) && silent.Timing.Equals(new Timing()), "counted");
            }
        }
    }

    /// <summary>A pinhole camera with a field of view of 90 degrees and 480 rows: a point as far to the side as in
    /// depth lies at the edge, 240 pixels from the middle.</summary>
    private static void ProjectionIsAPinholes()
    {
        using (var env = Ball())
        {
            // The camera looks along +y, so +x is to the right.
            var ahead = new PictureConfig { LookAt = new Vector3d(0, 0, 1), Distance = 2, Azimuth = 90, Elevation = 0, Fovy = 90 };
            var seen = env.Project(ahead, new Vector3d(0, 0, 1), new Vector3d(0.5, 0, 1.25), new Vector3d(0, -3, 1));
            Action<double, double, double, Vector3d> at = (x, y, depth, pixel) =>
            {
                Near(x, pixel.X, 1e-9, "to the right");
                Near(y, pixel.Y, 1e-9, "down");
                Near(depth, pixel.Z, 1e-9, "away");
            };
            at(320, 240, 2, seen[0]);
            at(320 + 240 * 0.25, 240 - 240 * 0.125, 2, seen[1]);
            Check(seen[2].Z < 0, "before the camera");
            Check(env.Project(ahead).Length == 0, "no points");
            ahead.Camera = "eye_third";
            Check(Refused(() => env.Project(ahead, new Vector3d())).Message.Contains("eye_third"), "another message");
        }
    }

    /// <summary>The nearest point of a ball of 4 cm radius at 2 m is at 1.96 m.</summary>
    private static void DepthAndSegmentationAreDrawn()
    {
        using (var env = Ball())
        {
            var close = new PictureConfig { LookAt = new Vector3d(0, 0, 2), Distance = 2, Elevation = 0, Fovy = 90 };
            var middle = 240 * 640 + 320;
            var depth = new float[480 * 640];
            var geoms = new int[480 * 640];
            env.Draw(close, null, depth, geoms);
            Near(1.96, depth[middle], 1e-3, "depth");
            Check(geoms[middle] == env.Find(Kind.Geom, "ball") && geoms[0] == -1, "the ball and nothing");
            var error = Refused(() => env.Draw(close, null, new float[3]));
            Check(error.Status == Status.BufferTooSmall && error.Message.Contains("3"), error.Message);
        }
    }

    private static void BodiesOfThingsAreFound()
    {
        using (var env = Ball())
        {
            var ball = env.Find(Kind.Body, "ball");
            Check(env.BodyOf(Kind.Geom, env.Find(Kind.Geom, "ball")) == ball && env.BodyOf(Kind.Joint, 0) == ball, "of the ball");
            Check(env.BodyOf(Kind.Body, ball) == 0, "it hangs on the world");
            Check(Refused(() => env.BodyOf(Kind.Geom, 99)).Message.Contains("99"), "another message");
        }
    }

    /// <summary>The collector moves objects while a step is running.</summary>
    private static void SentStepsEqualSteps()
    {
        using (Batch plain = ReachBatch(3), sent = ReachBatch(3))
        {
            var seeds = new ulong[] { 5, 6, 7 };
            plain.Reset(seeds);
            sent.Reset(seeds);
            Check(Refused(sent.Receive).Status == Status.Busy, "nothing was sent");
            for (var step = 0; step < 5; ++step)
            {
                var actions = Enumerable.Range(0, 3 * plain.Layout.Actions.Count).Select(i => (i + step) % 7 / 7f - 0.4f).ToArray();
                plain.Step(actions);
                sent.Send((float[])actions.Clone());
                GC.Collect();
                Check(Refused(() => sent.Step(actions)).Status == Status.Busy, "a step within a step");
                Check(Refused(() => sent.Send(null)).Status == Status.Busy, "sent twice");
                sent.Receive();
                Check(plain.Blocks.SequenceEqual(sent.Blocks) && plain.Rewards.SequenceEqual(sent.Rewards), "differ in step " + step);
            }
        }
    }

    /// <summary>Only the library still uses the actions.</summary>
    private static void SentActionsArePinned()
    {
        using (var batch = ReachBatch(2))
        {
            var actions = SendNew(batch);
            for (var i = 0; i < 3; ++i)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
            Check(actions.IsAlive, "the actions were collected");
            batch.Receive();
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference SendNew(Batch batch)
    {
        var actions = new float[2 * batch.Layout.Actions.Count];
        batch.Send(actions);
        return new WeakReference(actions);
    }

    private static void SentStepsFailLikeSteps()
    {
        using (var batch = ReachBatch(2))
        {
            batch.Reset(new ulong[] { 1, 2 });
            var actions = new float[2 * batch.Layout.Actions.Count];
            actions[batch.Layout.Actions.Count] = float.NaN;
            batch.Send(actions);
            Check(Refused(batch.Receive).Message.Contains("world 1"), "which world");
            Check(batch.World(0).Time > 0 && batch.World(1).Time == 0, "one has gone on");
            Check(Refused(() => batch.Send(new float[3])).Message.Contains("3"), "three actions");
            batch.Send(null);
            batch.Receive();
            Check(batch.World(1).Time > 0, "time stands still");
        }
    }

    /// <summary>The library writes nothing into arrays that are gone after a batch was disposed or collected.</summary>
    private static void SentStepsEndWithTheBatch()
    {
        var blocks = SendAndForget();
        GC.Collect();
        GC.WaitForPendingFinalizers();
        var disposed = ReachBatch(2);
        disposed.Send(null);
        disposed.Dispose();
        Check(disposed.Blocks.Any(value => value != 0), "it was waited for");
        Check(blocks.Length > 0, "no blocks");
    }

    private static byte[] SendAndForget()
    {
        var batch = ReachBatch(2);
        batch.Send(new float[2 * batch.Layout.Actions.Count]);
        return batch.Blocks;
    }

    /// <summary>A batch has no more threads than worlds.</summary>
    private static void BatchesDescribeTheirSize()
    {
        using (Batch many = ReachBatch(5), one = ReachBatch(1))
            Check(many.Worlds == 5 && many.Threads == 2 && one.Worlds == 1 && one.Threads == 1, "sizes");
    }
}
