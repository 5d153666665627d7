// Two threads on one object: one call succeeds, the other one is Busy, and the object stays intact.
using System;
using System.Linq;
using System.Threading;
using Mimo;

internal static partial class Tests
{
    /// <summary>Runs a call on two threads until they collide. Returns the number of successful calls.</summary>
    private static int Hammer(Action call)
    {
        var done = new int[2];
        int busy = 0;
        Exception odd = null;
        using (var start = new Barrier(2))
        {
            var threads = Enumerable.Range(0, 2).Select(number => new Thread(() =>
            {
                start.SignalAndWait();
                for (var i = 0; i < 10000 && odd == null && (done[number] < 40 || Volatile.Read(ref busy) == 0); ++i)
                {
                    try
                    {
                        call();
                        ++done[number];
                    }
                    catch (MimoException error) when (error.Status == Status.Busy && error.Message.Contains("in use by another thread"))
                    {
                        Interlocked.Increment(ref busy);
                    }
                    catch (Exception error)
                    {
                        odd = error;
                    }
                }
            })).ToArray();
            foreach (var thread in threads) thread.Start();
            foreach (var thread in threads) thread.Join();
        }
        Check(odd == null, "another exception: " + odd);
        Check(busy > 0, "no call was busy");
        return done.Sum();
    }

    private static void SecondThreadOnAWorldIsBusy()
    {
        using (Env env = new Env("reach"), alone = new Env("reach"))
        {
            env.Reset(3);
            alone.Reset(3);
            var done = Hammer(() => env.Step(null));
            for (var i = 0; i < done; ++i) alone.Step(null);
            Check(env.Time == alone.Time, env.Time + " s, expected " + alone.Time);
            Check(env.Get(Quantity.JointPosition).SequenceEqual(alone.Get(Quantity.JointPosition)), "not the state after as many steps");
        }
    }

    private static void SecondThreadOnABatchIsBusy()
    {
        using (var batch = ReachBatch(2))
        {
            batch.Reset();
            var done = Hammer(() => batch.Step(null));
            Near(done * batch.World(0).FrameSkip * batch.World(0).Timestep, batch.World(0).Time, 1e-9, "whole steps");
        }
    }
}
