// Senses of one's own: their moments, memory and errors.
using System;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    /// <summary>Sums an elbow's angle over physics steps; its field has the number of steps and the sum.</summary>
    private sealed class ElbowSense : MimoSense
    {
        private readonly int[] elbow;
        private readonly Field balance;
        private readonly float[] felt = new float[3];
        private readonly double[] angle = new double[1];

        internal ElbowSense(SenseOpening opening)
        {
            elbow = new[] { opening.World.Find(Kind.Joint, opening.Prefix + "robot:left_elbow") };
            balance = opening.World.Layout.Find(opening.Prefix + "vestibular/acceleration");
            opening.Add(new SenseField(null, 2) { Unit = "rad", Labels = new[] { "ticks", "angles" } });
            opening.Add(new SenseField("balance", 3));
            opening.Memory = 2;
            opening.Sensors = true;
        }

        public override void Reset(SenseMoment moment)
        {
            Check(moment.Memory.All(number => number == 0) && moment.Tick == 0, "an episode starts from zeros");
        }

        public override void Advance(SenseMoment moment)
        {
            moment.World.Get(Quantity.JointPosition, elbow, angle);
            moment.Memory[0] += 1;
            moment.Memory[1] += moment.Parameters[0] * angle[0];
            Check(moment.Tick == (long)moment.Memory[0], "ticks are physics steps");
            if (moment.Tick == 7) throw new InvalidOperationException("no seventh");
        }

        public override void Write(SenseMoment moment)
        {
            moment.Feel(balance, felt);
            for (var i = 0; i < 2; ++i) moment.Fields[0][i] = (float)moment.Memory[i];
            felt.CopyTo(moment.Fields[1], 0);
        }
    }

    private static void SensesOfOnesOwnSeeEachPhysicsStep()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var infant = scene.DefaultAgent();
            infant.Vision = 0;
            scene.AddAgent(infant);
            var gain = new SenseParameter { Name = "gain", Description = "factor of the angle", Standard = 1, High = 4 };
            scene.AddSense("elbow", opening => new ElbowSense(opening), new[] { gain });
            Check(scene.SenseParameters.Single().Name == "elbow/gain", "parameters have the sense's name");
            Check(Refused(() => scene.SetParameter("elbow/gain", 5)).Message.Contains("expected 0 to 4"), "the range");
            scene.SetParameter("elbow/gain", 2);
            Check(Refused(() => scene.LoadSense("/none.so")).Status == Status.File, "no such library");
            using (var env = new Env(scene))
            {
                scene.Dispose();
                GC.Collect(); // only the world refers to the sense now
                float[] elbow = new float[2], balance = new float[3], vestibular = new float[3];
                env.Reset(1);
                for (var step = 1; step <= 3; ++step)
                {
                    env.Step(null);
                    env.Read(env.Layout.Find("elbow"), elbow);
                    Check(elbow[0] == 2 * step && elbow[1] != 0, "two physics steps a step");
                }
                env.Read(env.Layout.Find("elbow/balance"), balance);
                env.Read(env.Layout.Find("vestibular/acceleration"), vestibular);
                Check(balance.SequenceEqual(vestibular), "it feels what the organ of balance feels");
                var error = Refused(() => env.Step(null));
                Check(error.Status == Status.Task && error.Message.EndsWith("InvalidOperationException: no seventh"), error.Message);
            }
        }
        GC.Collect();
    }

    /// <summary>Throws in the function that the test names; its field is 1.</summary>
    private sealed class ThrowingSense : MimoSense
    {
        internal static string Throws = "";

        internal ThrowingSense(SenseOpening opening)
        {
            Throw("open");
            opening.Add(new SenseField());
        }

        private static void Throw(string function) { if (Throws == function) throw new InvalidOperationException("no nose"); }

        public override void Reset(SenseMoment moment) { Throw("reset"); }

        public override void Advance(SenseMoment moment) { Throw("advance"); }

        public override void Write(SenseMoment moment)
        {
            Throw("write");
            moment.Fields[0][0] = 1;
        }
    }

    private static void EachFunctionOfASenseMayThrow()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var infant = scene.DefaultAgent();
            infant.Vision = 0;
            scene.AddAgent(infant);
            scene.AddSense("nose", opening => new ThrowingSense(opening));
            Action<string, Action> fails = (function, call) =>
            {
                ThrowingSense.Throws = function;
                var error = Refused(call);
                ThrowingSense.Throws = "";
                Check(error.Status == Status.Task && error.Message.Contains("the sense \"nose\"'s function " + function + " returned")
                      && error.Message.EndsWith("no nose"), error.Message);
            };
            fails("open", () => new Env(scene).Dispose());
            using (var env = new Env(scene))
            {
                var nose = new float[1];
                fails("reset", () => env.Reset(1));
                env.Reset(1);
                fails("advance", () => env.Step(null));
                env.Read(env.Layout.Find("nose"), nose);
                Check(nose[0] == 0, "the field of a sense that failed is 0");
                fails("write", () => env.Step(null));
                env.Step(null);
                env.Read(env.Layout.Find("nose"), nose);
                Check(nose[0] == 1, "the world goes on");
            }
        }
    }
}
