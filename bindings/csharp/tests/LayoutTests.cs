// Layouts: fields, actions and reward terms.
using System;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    // An arm: a ball of 10 cm radius and 2 kg on a hinge. Physics steps of 2 ms.
    private const string OneArm = "<mujoco><worldbody><body name='arm' pos='0 0 1'><joint name='hinge' axis='0 1 0'/>" +
        "<geom name='skin' size='.1' mass='2' pos='.1 0 0'/><site name='mark'/></body></worldbody>" +
        "<actuator><motor name='pull' joint='hinge' ctrlrange='-2 3' ctrllimited='true'/><motor name='free' joint='hinge'/></actuator></mujoco>";

    private static MimoScene SceneOfOneArm()
    {
        var scene = MimoScene.FromXml(OneArm);
        var agent = scene.DefaultAgent();
        agent.Vision = Vision.None;
        agent.Proprioception = Proprioception.Position | Proprioception.Velocity;
        agent.Touch = MimoTouch.Force;
        agent.Body = "scene";
        agent.Root = "arm";
        agent.VestibularAt = "mark";
        scene.AddAgent(agent);
        return scene;
    }

    private static void ActionsAreDescribed()
    {
        using (var scene = SceneOfOneArm())
        using (var env = new Env(scene))
        {
            var actions = env.Layout.Actions;
            Check(actions.Select(action => action.Name).SequenceEqual(new[] { "pull", "free" }), "names");
            Check(actions[0].Low == -2 && actions[0].High == 3, "as the model says");
            Check(double.IsNegativeInfinity(actions[1].Low) && double.IsPositiveInfinity(actions[1].High), "without bounds");
            Check(actions.All(action => action.Agent == 0 && action.Unit == ""), "whose");
            var agent = env.Agent();
            Check(agent.Name == "" && agent.ActionOffset == 0 && agent.ActionCount == 2, "its actions");
            Near(2, agent.Mass, 1e-12, "mass");
            Near(0.2, agent.Height, 1e-12, "the ball's diameter");
            Check(Refused(() => env.Agent(1)).Message.Contains("1"), "one agent");
        }
    }

    /// <summary>Joint fields belong to the end of a step, sensor fields to the start of its last physics step, delayed
    /// fields to an earlier time.</summary>
    private static void FieldsHaveTimes()
    {
        using (var scene = SceneOfOneArm())
        {
            scene.LimitSense("proprioception/velocity", delay: 0.008);
            using (var env = new Env(scene, new EnvConfig { FrameSkip = 2 }))
            {
                Action<string, double> at = (name, time) =>
                {
                    var field = env.Layout.Find(name);
                    Near(time, field.Start, 1e-12, name);
                    Near(time, field.End, 1e-12, name);
                    Near(0.004, field.Period, 1e-12, name);
                };
                at("proprioception/position", 0);
                at("proprioception/velocity", -0.008);
                at("vestibular/acceleration", -0.002);
            }
        }
    }

    /// <summary>The delay is that of the nerve to the part that a joint moves and of the way through the brain, rounded
    /// to time steps of 5 ms.</summary>
    private static void NerveDelaysDependOnAge()
    {
        var newborn = Maturity.OfAge(0);
        Check(newborn.Acuity == 0.70 && Maturity.OfAge(24).Acuity == 11.1, "eyes");
        Check(Refused(() => Maturity.OfAge(25)).Message.Contains("age is 25"), "too old");
        using (var scene = MimoScene.Builtin("free"))
        {
            Check(Refused(() => scene.SetMaturity(newborn)).Status == Status.InvalidArgument, "whose");
            var agent = scene.DefaultAgent();
            agent.Vision = Vision.None;
            agent.Touch = MimoTouch.None;
            var growth = Growth.OfAge(0);
            Check(growth.Maturity == Mature.Body, "the body alone");
            growth.Maturity = Mature.Body | Mature.Delays;
            agent.Growth = growth;
            scene.AddAgent(agent);
            using (var env = new Env(scene))
            {
                var limits = env.Layout.Find("proprioception/limit");
                double[] late = limits.Delays(), lengths = env.Get(Quantity.BodyNerveLength);
                for (var i = 0; i < late.Length; ++i)
                {
                    var joint = env.Find(Kind.Joint, limits.Label(i));
                    var length = lengths[env.BodyOf(Kind.Joint, joint)];
                    Near(length / newborn.ConductionSpeed + newborn.SensoryDelay, late[i], 0.0025 + 1e-9, limits.Label(i));
                }
                Near(-late.Max(), limits.Start, 1e-12, "start");
                Near(-late.Min(), limits.End, 1e-12, "end");
                growth.Age = 18;
                env.Reset(1, growth);
                Check(limits.Delays().Sum() < late.Sum(), "grown");
                Near(-limits.Delays().Max(), limits.Start, 1e-12, "start of the grown one");
            }
            var slow = new Maturity();
            slow.VestibularDelay = 0.1;
            scene.SetMaturity(slow);
            using (var env = new Env(scene)) Near(0.1, env.Layout.Find("vestibular/acceleration").Delays()[0], 1e-12, "slow");
            scene.SetMaturity(null);
            using (var env = new Env(scene)) Near(0.005, env.Layout.Find("vestibular/acceleration").Delays()[0], 1e-12, "a newborn");
        }
    }

    private static void FieldsAreDescribed()
    {
        using (var scene = SceneOfOneArm())
        using (var env = new Env(scene))
        {
            var position = env.Layout.Find("proprioception/position");
            Check(position.Type == FieldType.F32 && position.Shape.SequenceEqual(new[] { 1 }) && position.Unit == "rad", "an angle");
            Check(position.Frame == "joint" && position.Label(0) == "hinge", position.Frame + " " + position.Label(0));
            Check(Refused(() => position.Label(1)).Message.Contains("1"), "one element");
            Check(env.Layout.Fields.Contains(position) && env.Layout.Fields.Last().Offset < env.Layout.BlockBytes, "fields");
            var error = Refused(() => env.Layout.Find("proprioception/positoin"));
            Check(error.Status == Status.NotFound && error.Message.Contains("proprioception/position"), error.Message);
        }
    }

    /// <summary>Sensors on a ball: their distance from its centre is its radius, and their normals point
    /// outwards.</summary>
    private static void ReceptorsLieOnTheSkin()
    {
        using (var scene = SceneOfOneArm())
        {
            scene.SetTouch(0, "arm", 0.05);
            using (var env = new Env(scene))
            {
                var touch = env.Layout.Find("touch/force");
                Check(touch.ReceptorCount > 20 && touch.Shape.SequenceEqual(new[] { touch.ReceptorCount, 3 }), "a field of skin");
                double[] places = touch.Receptors(Receptor.Position), frames = touch.Receptors(Receptor.Frame);
                for (var i = 0; i < touch.ReceptorCount; ++i)
                {
                    var outward = new[] { places[3 * i] - 0.1, places[3 * i + 1], places[3 * i + 2] };
                    Near(0.1, Math.Sqrt(outward.Sum(x => x * x)), 1e-6, "radius");
                    for (var k = 0; k < 3; ++k) Near(10 * outward[k], frames[9 * i + k], 1e-6, "normal");
                }
                double arm = env.Find(Kind.Body, "arm"), skin = env.Find(Kind.Geom, "skin");
                Check(touch.Receptors(Receptor.Body).All(id => id == arm) && touch.Receptors(Receptor.Geom).All(id => id == skin), "of what");
                var position = env.Layout.Find("proprioception/position");
                Check(position.ReceptorCount == 0, "joints are no skin");
                Check(Refused(() => touch.Receptors((Receptor)99)).Status == Status.Unsupported, "another status");
            }
        }
    }

    private static void LayoutsGoWithWhatTheyDescribe()
    {
        Field position;
        using (var scene = SceneOfOneArm())
        using (var batch = new Batch(scene, 2))
        {
            Check(ReferenceEquals(batch.World(1).Layout, batch.Layout), "worlds have the batch's");
            position = batch.Layout.Find("proprioception/position");
        }
        Check(position.Name == "proprioception/position" && Refused(() => position.Label(0)).Status == Status.BadHandle, "it is gone");
    }

    private static void AllAndNoneAreBits()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = Vision.None;
            agent.Touch = MimoTouch.None;
            agent.Proprioception = Proprioception.All;
            agent.Acts = Act.None;
            scene.AddAgent(agent);
            using (var env = new Env(scene))
            {
                env.Layout.Find("proprioception/effort");
                env.Layout.Find("proprioception/joint_torque");
                Check(env.Layout.Actions.Count == 0, "no motors");
            }
        }
    }

    /// <summary>A ball at (1, 2, 3) seen from a box at (1, 0, 1); g h n after n steps of 5 ms.</summary>
    private static void FieldsAreAddedOnRequest()
    {
        using (var scene = MimoScene.Empty())
        {
            scene.AddObject(new ObjectConfig { Name = "ball", Position = new Vector3d(1, 2, 3) });
            scene.AddObject(new ObjectConfig { Name = "box", Position = new Vector3d(1, 0, 1), Fixed = true });
            scene.AddField("things", Quantity.BodyPosition, new[] { "ball", "box" });
            scene.AddField("seen", Quantity.BodyPosition, new[] { "ball" }, "box");
            scene.AddField("speed", Quantity.BodyVelocity | Quantity.Now, new[] { "ball" });
            scene.AddField("gravity", Quantity.WorldGravity, null);
            Check(Refused(() => scene.AddField("seen", Quantity.BodyMass, new[] { "ball" })).Message.Contains("seen"), "a name twice");
            using (var env = new Env(scene, new EnvConfig { FrameSkip = 2 }))
            {
                var things = env.Layout.Find("things");
                Check(things.Shape.SequenceEqual(new[] { 2, 3 }) && things.Unit == "m", "two of three numbers");
                env.Reset(1);
                Check(ValuesOf(env, "things").SequenceEqual(new float[] { 1, 2, 3, 1, 0, 1 }), "places");
                Check(ValuesOf(env, "seen").SequenceEqual(new float[] { 0, 2, 2 }), "from the box");
                env.Step(null);
                Near(-9.81 * 0.005 * 2, ValuesOf(env, "speed")[2], 1e-7, "speed");
                Near(-9.81, ValuesOf(env, "gravity")[2], 1e-6, "gravity");
            }
            scene.AddField("unicorn", Quantity.BodyMass, new[] { "unicorn" });
            var error = Refused(() => new Env(scene));
            Check(error.Status == Status.NotFound && error.Message.Contains("ball"), error.Message);
        }
    }

    /// <summary>The goal of reach is the right fingers at the ball (docs/tasks.md).</summary>
    private static void GoalsAreObserved()
    {
        using (var scene = MimoScene.Builtin("reach"))
        {
            scene.AddAgent(scene.DefaultAgent());
            scene.AddField("goal", Quantity.AgentGoal, new[] { "" });
            scene.AddField("achieved", Quantity.AgentAchieved, new[] { "" });
            using (var env = new Env(scene))
            {
                env.Reset(2);
                env.Step(null);
                var places = new double[6];
                env.Get(Quantity.BodyPosition, new[] { env.Find(Kind.Body, "target"), env.Find(Kind.Body, "right_fingers") }, places);
                Check(env.Get(Quantity.AgentGoal).Concat(env.Get(Quantity.AgentAchieved)).SequenceEqual(places), "read");
                var observed = ValuesOf(env, "goal").Concat(ValuesOf(env, "achieved"));
                Check(observed.SequenceEqual(places.Select(place => (float)place)), "observed");
            }
        }
    }

    private static float[] ValuesOf(Env env, string name)
    {
        var field = env.Layout.Find(name);
        var values = new float[field.Bytes / 4];
        env.Read(field, values);
        return values;
    }
}
