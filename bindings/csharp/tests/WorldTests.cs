// Contacts, states, faces, gaze and cameras of worlds.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Mimo;

internal static partial class Tests
{
    /// <summary>The scene "free" with an infant without vision and touch.</summary>
    private static MimoScene Room()
    {
        var scene = MimoScene.Builtin("free");
        var agent = scene.DefaultAgent();
        agent.Vision = 0;
        agent.Touch = 0;
        agent.Face = "sadness";
        scene.AddAgent(agent);
        return scene;
    }

    /// <summary>A ball of 1 kg on the floor weighs 9.81 N, from the scene's gravity.</summary>
    private static void ContactsCarryTheWeight()
    {
        const string floor = "<mujoco><worldbody><geom name='floor' type='plane' size='1 1 .1'/></worldbody></mujoco>";
        using (var scene = MimoScene.FromXml(floor))
        {
            scene.AddObject(new ObjectConfig
            {
                Name = "ball", Size = new Vector3d(0.1, 0, 0), Position = new Vector3d(0, 0, 0.0999), Mass = 1
            });
            using (var env = new Env(scene, new EnvConfig { FrameSkip = 1 }))
            {
                env.Reset();
                for (var i = 0; i < 400; ++i) env.Step(null);
                var contact = env.Contacts().Single();
                Near(9.81, Math.Abs(contact.Force.Z), 0.01, "weight");
                Near(0, contact.Force.X, 1e-6, "sideways");
                Near(1, Math.Abs(contact.Normal.Z), 1e-12, "upwards");
                Check(contact.Geom1 == env.Find(Kind.Geom, "floor") && contact.Body2 == env.Find(Kind.Body, "ball"), "who");
            }
        }
    }

    /// <summary>A median girl of 6 months weighs 7.297 kg, the mean infant of 18 months 10.585 kg: WHO Child Growth
    /// Standards, 2006. The library's infant of 18 months weighs 10.905 kg.</summary>
    private static void InfantsHaveTheMassOfTheirAge()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            var growth = Growth.OfAge(24.5);
            agent.Growth = growth;
            Check(Refused(() => scene.AddAgent(agent)).Message.Contains("age is 24.5"), "another message");
            growth.Age = 6;
            growth.Sex = Sex.Female;
            scene.AddAgent(agent);
            using (var env = new Env(scene)) Near(7.297 / 10.585 * 10.905, env.Agent().Mass, 0.04, "mass of a girl");
        }
    }

    private const string HeavyBall = "<mujoco><option timestep='0.005'/><worldbody><geom type='plane' size='5 5 .1'/>" +
        "<body name='ball' pos='0 0 .3'><freejoint/><geom size='0.1' mass='2'/></body></worldbody></mujoco>";

    /// <summary>v = F / m t in the worlds of a batch, each with its own mass.</summary>
    private static void MassesDifferBetweenWorlds()
    {
        using (var scene = MimoScene.FromXml(HeavyBall))
        using (var batch = new Batch(scene, 3))
        {
            var ball = new[] { batch.World(0).Find(Kind.Body, "ball") };
            var masses = new[] { 0.5, 1, 4 };
            batch.Set(Quantity.BodyMass, ball, masses);
            batch.Set(Quantity.WorldGravity, null, new double[9]);
            batch.Set(Quantity.BodyForce, ball, new double[] { 3, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0 });
            for (var i = 0; i < 10; ++i) batch.Step(null);
            var velocity = new float[18];
            batch.Get(Quantity.BodyVelocity | Quantity.Now, ball, velocity);
            for (var i = 0; i < 3; ++i) Near(3 / masses[i] * 10 * 2 * 0.005, velocity[6 * i], 1e-6, "speed");
            Check(Refused(() => batch.Set(Quantity.BodyMass, ball, new double[3])).Message.Contains("above 0"), "another message");
        }
    }

    /// <summary>The impulses of all contacts of a step and of gravity add up to the change of momentum.</summary>
    private static void StepContactsAddUpToMomentum()
    {
        using (var scene = MimoScene.FromXml(HeavyBall))
        using (var env = new Env(scene, new EnvConfig { FrameSkip = 20, StepContacts = true }))
        {
            var touched = false;
            for (var i = 0; i < 10; ++i)
            {
                var before = env.Get(Quantity.JointVelocity)[2];
                env.Step(null);
                var contacts = env.StepContacts();
                var change = 2 * (env.Get(Quantity.JointVelocity)[2] - before);
                Near(change, contacts.Sum(contact => contact.Impulse.Z) - 2 * 9.81 * 0.1, 1e-9, "momentum");
                touched = touched || contacts.Length > 0;
            }
            Check(touched, "it has landed");
            Check(env.Get(Quantity.WarningSteps).All(count => count == 0), "a clean run");
        }
    }

    /// <summary>A site half a metre from an axis that turns at 2 rad/s: v = w r.</summary>
    private static void SitesMoveWithTheirBodies()
    {
        const string arm = "<mujoco><worldbody><body><joint axis='0 0 1'/><geom size='.1' pos='.5 0 0'/><site name='tip' pos='.5 0 0'/>" +
            "</body></worldbody></mujoco>";
        using (var scene = MimoScene.FromXml(arm))
        using (var env = new Env(scene))
        {
            env.Set(Quantity.JointVelocity, null, 2);
            var velocity = env.Get(Quantity.SiteVelocity | Quantity.Now);
            var expected = new[] { 0, 1, 0, 0, 0, 2.0 };
            for (var i = 0; i < 6; ++i) Near(expected[i], velocity[i], 1e-12, "velocity " + i);
        }
    }

    private static void SavedStateContinues()
    {
        using (var env = new Env("reach"))
        {
            var action = Enumerable.Repeat(0.5f, env.Layout.Actions.Count).ToArray();
            env.Reset(3);
            env.Step(action);
            var state = env.Save();
            using (var clone = env.Clone())
            {
                env.Step(action);
                var then = (byte[])env.Block.Clone();
                clone.Step(action);
                Check(then.SequenceEqual(clone.Block), "the clone goes elsewhere");
                env.Load(state);
                env.Step(action);
                Check(then.SequenceEqual(env.Block), "the state goes elsewhere");
            }
            Check(Refused(() => env.Load(new byte[3])).Message.Contains("state"), "another message");
        }
    }

    private static void LocksAndGravity()
    {
        using (var env = new Env("benchmark"))
        {
            var elbow = env.Find(Kind.Joint, "robot:left_elbow");
            Check(env.Locked(elbow) == null, "locked from the start");
            env.Lock(elbow, -0.5);
            Check(env.Locked(elbow) == -0.5, "is held");
            env.Unlock(elbow);
            Check(env.Locked(elbow) == null, "let go");
            Near(-9.81, env.Gravity.Z, 0, "gravity");
            env.Gravity = new Vector3d(0, 0, -1.6);
            Near(-1.6, env.Gravity.Z, 0, "on the Moon");
            Check(Refused(() => env.Lock(elbow, 99)).Message.Contains("angle"), "another message");
        }
    }

    /// <summary>The feet move up by as much as the position of the soles.</summary>
    private static void SolesGoToThePosition()
    {
        Func<double, double[]> feet = height =>
        {
            using (var scene = MimoScene.Builtin("free"))
            {
                var agent = scene.DefaultAgent();
                agent.Vision = 0;
                agent.Touch = 0;
                agent.Vestibular = Vestibular.Acceleration;
                agent.Place = Place.Soles;
                agent.Position = new Vector3d(0.5, 0, height);
                scene.AddAgent(agent);
                using (var env = new Env(scene))
                {
                    var values = new double[6];
                    env.Get(Quantity.BodyPosition, new[] { env.Find(Kind.Body, "left_foot"), env.Find(Kind.Body, "right_foot") }, values);
                    return values;
                }
            }
        };
        double[] low = feet(0.2), high = feet(0.7);
        Check(Math.Abs((low[0] + low[3]) / 2 - 0.5) < 1e-12, "between the feet");
        Check(Math.Abs(high[2] - low[2] - 0.5) < 1e-9, "half a metre higher");
    }

    /// <summary>An arm on a hinge, sensed at twice its speed and one step late.</summary>
    private static void SensesAreLimited()
    {
        const string arm = "<mujoco><worldbody><body name='arm'><joint name='hinge' axis='0 1 0'/><geom type='capsule' " +
            "fromto='0 0 0 .3 0 0' size='.02'/></body></worldbody></mujoco>";
        Func<bool, double, float[]> speeds = (limited, shakes) =>
        {
            using (var scene = MimoScene.FromXml(arm))
            {
                var agent = scene.DefaultAgent();
                agent.Vision = 0;
                agent.Vestibular = 0;
                agent.Touch = 0;
                agent.Body = "scene";
                agent.Root = "arm";
                scene.AddAgent(agent);
                scene.ReadJoint("hinge");
                if (limited) scene.LimitSense("proprioception/velocity", gain: 2, delay: 0.004); // two time steps of 2 ms
                if (shakes > 0) scene.LimitSense("proprioception/velocity", signalNoise: shakes);
                using (var env = new Env(scene))
                {
                    var seen = new List<float>();
                    var one = new float[1];
                    env.Reset(1);
                    for (var i = 0; i < 3; ++i)
                    {
                        env.Step(null);
                        env.Read(env.Layout.Find("proprioception/velocity"), one);
                        seen.Add(one[0]);
                    }
                    return seen.ToArray();
                }
            }
        };
        float[] plain = speeds(false, 0), late = speeds(true, 0), shaky = speeds(false, 0.01);
        Check(plain[0] != plain[1] && plain[0] != 0, "the arm does not fall");
        Near(2 * plain[1], late[2], 1e-6, "twice and late");
        for (var i = 0; i < 3; ++i) Check(shaky[i] != plain[i] && Math.Abs(shaky[i] / plain[i] - 1) < 0.06, "noise");
    }

    /// <summary>A room, an infant with locked and posed joints, and a cup that is welded to the world.</summary>
    private static void ScenesAreEditedAndSaved()
    {
        const string cup = "<mujoco><worldbody><body><geom name='side' size='.03'/></body></worldbody></mujoco>";
        using (var scene = MimoScene.Empty())
        {
            scene.SetRoom("playroom");
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Touch = 0;
            Check(scene.AddAgents(agent) == 1, "one infant");
            scene.AddModel("cup", new Vector3d(1, 0.5, 0.5), xml: cup);
            scene.Weld("cup");
            scene.Lock("robot:left_elbow", -0.5);
            scene.SetPose("robot:right_elbow", -0.7);
            var folder = System.IO.Path.Combine(System.IO.Path.GetTempPath(), System.IO.Path.GetRandomFileName());
            scene.Save(folder);
            Check(System.IO.File.Exists(System.IO.Path.Combine(folder, "scene.xml")), "saved");
            System.IO.Directory.Delete(folder, true);
            using (var env = new Env(scene))
            {
                env.Reset(1);
                var angles = new double[2];
                env.Get(Quantity.JointPosition, new[] { env.Find(Kind.Joint, "robot:left_elbow"), env.Find(Kind.Joint, "robot:right_elbow") }, angles);
                Check(angles[0] == -0.5 && angles[1] == -0.7, "poses");
                env.Find(Kind.Geom, "cup/side");
                for (var i = 0; i < 50; ++i) env.Step(null);
                var place = new double[3];
                env.Get(Quantity.BodyPosition, new[] { env.Find(Kind.Body, "cup") }, place);
                Check(place[2] > 0.45, "it fell to " + place[2]);
            }
        }
    }

    /// <summary>Skin of 33.0 degrees after 1 s on a body of 10 degrees: two half-spaces in contact (skin's effusivity:
    /// J Appl Physiol 1957;11:211) through 350 W/(m^2 K) give 28.21 on copper, 30.26 on hardwood.</summary>
    private static void MetalFeelsColderThanWood()
    {
        Near(28.21, SkinOn("copper"), 0.1, "copper");
        Near(30.26, SkinOn("hardwood"), 0.1, "hardwood");
        Check(Materials.Names.Contains("cork"), string.Join(" ", Materials.Names));
        using (var scene = MimoScene.FromXml(Table))
        {
            Check(Refused(() => scene.SetMaterial("table", "kryptonite")).Message.Contains("copper"), "no list");
            Check(Refused(() => scene.SetTemperature("table", -274)).Message.Contains("-274"), "below absolute zero");
            Refused(() => scene.SetRoomTemperature(81));
            scene.SetRoomTemperature(20);
        }
    }

    private const string Table =
        "<mujoco><option timestep='.005'/><worldbody><body name='table'><geom type='box' size='1 1 .1' pos='0 0 -.1'/></body>" +
        "<body name='arm' pos='0 0 .0999'><freejoint/><geom size='.1'/></body></worldbody></mujoco>";

    private static double SkinOn(string material)
    {
        using (var scene = MimoScene.FromXml(Table))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Vestibular = 0;
            agent.Touch = MimoTouch.Temperature;
            agent.Body = "scene";
            agent.Root = "arm";
            scene.AddAgent(agent);
            scene.SetTouch(0, "arm", 0.05);
            scene.SetTemperature("table", 10);
            scene.SetMaterial("table", material);
            using (var env = new Env(scene, new EnvConfig { FrameSkip = 1 }))
            {
                env.Reset(1);
                for (var i = 0; i < 200; ++i) env.Step(null);
                var skin = env.Layout.Find("touch/temperature");
                var degrees = new float[skin.Bytes / 4];
                env.Read(skin, degrees);
                return degrees.Min();
            }
        }
    }

    private static void FacesAreVisible()
    {
        Check(Faces.Names.Count == 7 && Faces.Names.Contains("fear"), "no emotion, and the six basic ones");
        using (var scene = Room())
        using (var env = new Env(scene))
        {
            Check(env.Face() == "sadness", env.Face());
            var head = new double[3];
            env.Get(Quantity.BodyPosition, new[] { env.Find(Kind.Body, "head") }, head);
            var close = new PictureConfig
            {
                Width = 64, Height = 64, LookAt = new Vector3d(head[0], head[1], head[2] + 0.07), Distance = 0.3, Azimuth = 180
            };
            byte[] sad = new byte[64 * 64 * 4], afraid = new byte[64 * 64 * 4];
            env.Draw(close, sad);
            env.SetFace("fear");
            env.Draw(close, afraid);
            Check(!sad.SequenceEqual(afraid), "it looks the same");
            Check(Refused(() => env.SetFace("boredom")).Status == Status.NotFound, "another status");
        }
    }

    /// <summary>The eyes' centres are 49 mm apart: the vergence at a distance d straight ahead is 2 atan(0.0245 m /
    /// d).</summary>
    private static void LinesOfSightMeet()
    {
        using (var scene = Room())
        using (var env = new Env(scene))
        {
            var before = env.Gaze();
            var point = new Vector3d((before.LeftPosition.X + before.RightPosition.X) / 2 + 0.4,
                (before.LeftPosition.Y + before.RightPosition.Y) / 2, before.LeftPosition.Z);
            var planned = env.LookAngles(point, Look.Head);
            Check(planned.Joints.Length == 8 && planned.Angles.Length == 8, "head and eyes");
            Check(env.LookAngles(point).Joints.Length == 6, "eyes alone");
            Check(env.LookAt(point, Look.Head).All(error => Math.Abs(error) < 1e-6), "in range");
            var angles = new double[8];
            env.Get(Quantity.JointPosition, planned.Joints, angles);
            for (var i = 0; i < 8; ++i) Near(planned.Angles[i], angles[i], 1e-12, "angle");
            var gaze = env.Gaze();
            Near(point.X, gaze.Point.X, 1e-6, "x");
            Near(point.Y, gaze.Point.Y, 1e-6, "y");
            Near(point.Z, gaze.Point.Z, 1e-6, "z");
            Near(2 * Math.Atan(0.0245 / 0.4), gaze.Vergence, 0.02, "vergence");
        }
    }

    private static void CamerasAreFieldsAndPictures()
    {
        using (var scene = Room())
        {
            scene.AddCamera(new CameraConfig
            {
                Name = "wall", Placed = true, Width = 32, Height = 24, Outputs = Vision.Rgb | Vision.Segmentation,
                Position = new Vector3d(1.5, 0, 0.8), LookAt = new Vector3d(0, 0, 0.4)
            });
            scene.AddCamera(new CameraConfig
            {
                Name = "palm", Placed = true, Width = 8, Height = 8, Body = "left_hand", Position = new Vector3d(), LookAt = new Vector3d(0, 0, 1)
            });
            scene.AddCamera(new CameraConfig { Name = "eye_left", Width = 16, Height = 8 });
            scene.SetTouch(0, "left_hand", 0.01);
            var options = new EnvConfig { Render = Render.Shadows | Render.Sky, Samples = 4, RenderThreads = 2 };
            using (var env = new Env(scene, options))
            {
                env.Reset(1);
                Check(env.Layout.Find("vision/eye_left").Shape.SequenceEqual(new[] { 8, 16, 3 }), "rows first");
                Check(env.Layout.Find("vision/palm").Bytes == 8 * 8 * 3, "palm");
                var geoms = new int[32 * 24];
                env.Read(env.Layout.Find("vision/wall_segmentation"), geoms);
                Check(geoms.Contains(env.Find(Kind.Geom, "floor")), "no floor");
                byte[] seen = new byte[32 * 24 * 4], drawn = new byte[32 * 24 * 4];
                env.ReadRgba(env.Layout.Find("vision/wall"), seen, true);
                env.Draw(new PictureConfig { Camera = "wall", Width = 32, Height = 24, BottomUp = true }, drawn);
                Check(seen.SequenceEqual(drawn), "the field and the picture differ");
            }
            Check(Refused(() => new Env(scene, new EnvConfig { Samples = 3 })).Message.Contains("samples is 3"), "another message");
        }
    }

    /// <summary>New configs have the library's defaults, and all their members reach the struct.</summary>
    private static void ConfigsStartWithTheDefaults()
    {
        var ball = new ObjectConfig();
        Check(ball.Shape == Shape.Sphere && ball.Size.X == 0.04 && ball.Mass == 0.1 && !ball.Fixed && ball.Name == null, "object");
        var photo = new PictureConfig();
        Check(photo.Width == 640 && photo.Height == 480 && photo.Fovy == 0 && !photo.BottomUp, "picture");
        var world = new EnvConfig();
        Check(world.Renderer == "auto" && world.RenderThreads == 1 && world.Task == null && !world.Timing, "world");
        Check(world.Render == (Render.Shadows | Render.Reflections | Render.Sky | Render.Haze), "all but fog");
        var agent = new AgentConfig { Body = "fingers", Name = "anna", Face = "fear", Root = "arm", VestibularAt = "mark", Growth = Growth.OfAge(3) };
        agent.NormalizeActions = agent.Voice = true;
        using (var parts = new PinnedParts())
        {
            var raw = agent.Raw(parts);
            Check(Utf8.Of(raw.body) == "fingers" && Utf8.Of(raw.name) == "anna" && Utf8.Of(raw.face) == "fear", "names");
            Check(Utf8.Of(raw.root) == "arm" && Utf8.Of(raw.vestibular_at) == "mark", "further names");
            Check(raw.normalize_actions == 1 && raw.voice == 1, "switches");
            Check(((GrowthStruct)Marshal.PtrToStructure(raw.growth, typeof(GrowthStruct))).age == 3, "growth");
        }
    }

    /// <summary>The force that holds an infant still is its weight, at the third degree of freedom of its free
    /// joint.</summary>
    private static void FollowReturnsForces()
    {
        using (var scene = MimoScene.Builtin("free"))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Touch = 0;
            scene.AddAgent(agent);
            using (var env = new Env(scene, new EnvConfig { FrameSkip = 1 }))
            {
                var still = env.Get(Quantity.JointPosition);
                env.Follow(still);
                Near(9.81 * env.Agent().Mass, env.Follow(still)[2], 1e-6, "the force that holds it");
                Check(Refused(() => env.Follow(new double[3])).Message.Contains("position_count"), "another message");
            }
        }
    }
}
