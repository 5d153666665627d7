// The worlds of a batch behave like single worlds.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Mimo;

internal static partial class Tests
{
    private static Batch ReachBatch(int worlds, uint steps = 0, Autoreset autoreset = Autoreset.None)
    {
        using (var scene = ReachScene())
            return new Batch(scene, worlds, new EnvConfig { MaxSteps = steps }, autoreset, threads: 2);
    }

    private static MimoScene ReachScene()
    {
        var scene = MimoScene.Builtin("reach");
        scene.AddAgents(scene.DefaultAgent());
        return scene;
    }

    private static byte[] BlockOf(Batch batch, int world)
    {
        return batch.Blocks.Skip(world * batch.Layout.BlockBytes).Take(batch.Layout.BlockBytes).ToArray();
    }

    private static void BatchesEqualSingleWorlds()
    {
        using (var batch = ReachBatch(3))
        using (var single = new Env("reach"))
        {
            var actions = new float[3 * batch.Layout.Actions.Count];
            for (var i = 0; i < actions.Length; ++i) actions[i] = i % 7 / 7f - 0.4f;
            batch.Reset(new ulong[] { 5, 6, 7 });
            batch.Step(actions);
            var velocity = batch.Layout.Find("proprioception/velocity");
            float[] ours = new float[47], theirs = new float[47]; // MIMo's joints in reach
            for (var world = 0; world < 3; ++world)
            {
                single.Reset((ulong)(5 + world));
                var step = single.Step(actions.Skip(world * batch.Layout.Actions.Count).Take(batch.Layout.Actions.Count).ToArray());
                Check(BlockOf(batch, world).SequenceEqual(single.Block), "other bytes in world " + world);
                Check(batch.StepOf(world).Reward == step.Reward && batch.Rewards[world] == step.Reward, "other rewards");
                Check(batch.Terms.Skip(2 * world).Take(2).SequenceEqual(single.Terms), "other terms"); // reach has two
                batch.Read(world, velocity, ours);
                single.Read(velocity, theirs);
                Check(ours.SequenceEqual(theirs), "other velocities");
            }
        }
    }

    private static void BatchStatesAndMasks()
    {
        using (var batch = ReachBatch(3))
        {
            var actions = Enumerable.Repeat(0.3f, 3 * batch.Layout.Actions.Count).ToArray();
            batch.Reset(new ulong[] { 5, 6, 7 });
            var states = batch.Save();
            batch.Step(actions);
            byte[] first = BlockOf(batch, 1), last = BlockOf(batch, 2);
            batch.Load(states);
            batch.Load(states.Skip(states.Length / 3).Take(states.Length / 3).ToArray(), new[] { true, true, false });
            batch.Step(actions);
            Check(BlockOf(batch, 0).SequenceEqual(first) && BlockOf(batch, 1).SequenceEqual(first), "two futures of one state");
            Check(BlockOf(batch, 2).SequenceEqual(last), "a future of its own");

            batch.Reset(mask: new[] { false, true, false });
            Check(batch.World(1).Time == 0 && batch.World(0).Time > 0, "one was to be reset");
            Check(BlockOf(batch, 2).SequenceEqual(last), "others stay");
            batch.SetFace("anger", mask: new[] { true, false, false });
            Check(batch.World(0).Face() == "anger" && batch.World(1).Face() == "neutral", "one face");
            Check(Refused(() => batch.SetFace("anger", mask: new[] { true })).Message.Contains("worlds is 1"), "another message");

            var joint = new[] { batch.World(0).Find(Kind.Joint, "robot:right_elbow") };
            batch.Set(Quantity.JointPosition, joint, new[] { -0.1, -0.2, -0.3 }, new[] { true, false, true });
            var angles = new double[3];
            batch.Get(Quantity.JointPosition, joint, angles);
            Check(angles[0] == -0.1 && angles[1] != -0.2 && angles[2] == -0.3, "masked angles");
            var before = BlockOf(batch, 0);
            batch.Observe(new[] { true, false, false });
            Check(!BlockOf(batch, 0).SequenceEqual(before), "observed anew");
        }
    }

    private static void BatchErrorsAndEnds()
    {
        using (var batch = ReachBatch(2, 1, Autoreset.SameStep))
        {
            batch.Reset(new ulong[] { 1, 2 });
            var actions = new float[2 * batch.Layout.Actions.Count];
            actions[batch.Layout.Actions.Count] = float.NaN;
            Check(Refused(() => batch.Step(actions)).Message.Contains("world 1"), "which world");
            Check(batch.ErrorOf(0) == "" && batch.ErrorOf(1).Contains("not a number"), "messages");
            batch.Step(null);
            Check(batch.StepOf(1).Truncated && batch.WasReset(1), "an episode of one step");
            try { batch.Reset(new ulong[1]); }
            catch (ArgumentException) { return; }
            throw new Exception("one seed for two worlds");
        }
    }

    /// <summary>The last block of an ended episode is kept, and Blocks has the first one of the next episode.</summary>
    private static void LastBlocksAreKept()
    {
        using (Batch batch = ReachBatch(2, 1, Autoreset.SameStep), plain = ReachBatch(1))
        using (var single = new Env("reach"))
        {
            Check(plain.FinalBlocks == null, "nobody would write there");
            batch.Reset(new ulong[] { 5, 6 });
            batch.Step(null);
            single.Reset(6);
            single.Step(null);
            Check(batch.HasFinal(1) && batch.WasReset(1), "an episode of one step");
            var last = batch.FinalBlocks.Skip(batch.Layout.BlockBytes).ToArray();
            Check(last.SequenceEqual(single.Block) && !BlockOf(batch, 1).SequenceEqual(single.Block), "other blocks");
            var velocity = batch.Layout.Find("proprioception/velocity");
            float[] ours = new float[47], theirs = new float[47]; // MIMo's joints in reach
            batch.ReadFinal(1, velocity, ours);
            single.Read(velocity, theirs);
            Check(ours.SequenceEqual(theirs), "other velocities");
        }
    }

    /// <summary>A world keeps its batch and the batch's log alive after the last reference to the batch is
    /// gone.</summary>
    private static void WorldsKeepTheirBatchAlive()
    {
        var world = ReachBatch(2).World(1);
        for (var i = 0; i < 3; ++i)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }
        world.Step(null);
        Check(world.Time > 0, "time stands still");
        var batch = ReachBatch(1);
        var gone = batch.World(0);
        batch.Dispose();
        Check(Refused(() => gone.Step(null)).Status == Status.BadHandle, "stepped after its end");
    }
}
