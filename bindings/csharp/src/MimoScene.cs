using System;
using System.Linq;
using System.Text;

namespace Mimo
{
    /// <summary>A room, objects and infants. Worlds that were made of it live on without it.</summary>
    public sealed class MimoScene : IDisposable
    {
        private readonly SceneHandle owned;
        internal SceneHandle Handle => Ending.Pass(owned);

        private MimoScene(SceneConfig config, string name = null, string file = null, string xml = null)
        {
            Library.Require();
            owned = (config ?? new SceneConfig()).Make(name, file, xml);
        }

        /// <summary>An empty world.</summary>
        public static MimoScene Empty(SceneConfig config = null) { return new MimoScene(config); }

        /// <summary>A built-in scene, one of Scenes.Names: "reach", "benchmark", ...</summary>
        public static MimoScene Builtin(string name, SceneConfig config = null)
        {
            return new MimoScene(config, name: Given.Text(name, "name", "that of a built-in scene, one of Scenes.Names"));
        }

        /// <summary>An MJCF file.</summary>
        public static MimoScene FromFile(string path, SceneConfig config = null)
        {
            return new MimoScene(config, file: Given.Text(path, "path", "that of an MJCF file"));
        }

        /// <summary>MJCF text.</summary>
        public static MimoScene FromXml(string xml, SceneConfig config = null)
        {
            return new MimoScene(config, xml: Given.Text(xml, "xml", "MJCF text"));
        }

        /// <summary>The agent that the scene gives by default, with its body and place.</summary>
        public AgentConfig DefaultAgent()
        {
            AgentConfigStruct raw;
            MimoException.Check(Native.mimo_scene_default_agent(Handle, out raw, (UIntPtr)AgentConfigStruct.Bytes));
            return new AgentConfig(raw);
        }

        /// <summary>Adds an agent and returns its number.</summary>
        public int AddAgent(AgentConfig config)
        {
            using (var parts = new PinnedParts())
            {
                var raw = Given.Some(config, "config", "an AgentConfig").Raw(parts);
                UIntPtr agent;
                MimoException.Check(Native.mimo_scene_add_agent(Handle, ref raw, out agent));
                return (int)agent;
            }
        }

        /// <summary>Adds all infants that the scene names, each at a place of its own, or a single one where the scene names
        /// none. Returns how many were added. config.Name and the places in it do not count.</summary>
        public int AddAgents(AgentConfig config)
        {
            using (var parts = new PinnedParts())
            {
                var raw = Given.Some(config, "config", "an AgentConfig").Raw(parts);
                UIntPtr count;
                MimoException.Check(Native.mimo_scene_add_agents(Handle, ref raw, out count));
                return (int)count;
            }
        }

        /// <summary>Gives a scene that has none a room, one of Rooms.Names: "playroom".</summary>
        public void SetRoom(string name) { MimoException.Check(Native.mimo_scene_set_room(Handle, Utf8.Bytes(name))); }

        /// <summary>Adds an MJCF document with one body as an object: a file, or a text. All its names get its name and '/'
        /// before them.</summary>
        public void AddModel(string name, Vector3d position, string file = null, string xml = null, bool isFixed = false)
        {
            using (var parts = new PinnedParts())
            {
                var config = ModelConfigStruct.New();
                config.name = parts.Text(name);
                config.file = parts.Text(file);
                config.xml = parts.Text(xml);
                config.position = position;
                config.@fixed = isFixed ? 1u : 0u;
                MimoException.Check(Native.mimo_scene_add_model(Handle, ref config));
            }
        }

        /// <summary>Fastens a body softly to another one, null: to the world, as they are to each other where the scene
        /// starts.</summary>
        public void Weld(string body, string other = null)
        {
            MimoException.Check(Native.mimo_scene_weld(Handle, Utf8.Bytes(body), Utf8.Bytes(other), null));
        }

        /// <summary>Holds a hinge or slide softly, and starts it there, rad or m.</summary>
        public void Lock(string joint, double value)
        {
            MimoException.Check(Native.mimo_scene_lock(Handle, Utf8.Bytes(joint), value));
        }

        /// <summary>Sets where a hinge or slide starts, rad or m.</summary>
        public void SetPose(string joint, double value)
        {
            MimoException.Check(Native.mimo_scene_set_pose(Handle, Utf8.Bytes(joint), value));
        }

        /// <summary>How many bodies can play at once, 4 unless this is called, and for how long sounds can wait at each, 4 s.</summary>
        public void SetSources(int count, double seconds)
        {
            MimoException.Check(Native.mimo_scene_set_sources(Handle, Given.Index(count, "count"), seconds));
        }

        /// <summary>From where a body plays and whereto, in its frame: 0 alike to all sides, 0.5 a cardioid, 1 a figure of eight.</summary>
        public void DirectSource(string body, double[] place, double[] axis, double directivity)
        {
            if (place == null || place.Length != 3) throw new ArgumentException("expected 3 numbers", nameof(place));
            if (axis == null || axis.Length != 3) throw new ArgumentException("expected 3 numbers", nameof(axis));
            MimoException.Check(Native.mimo_scene_direct_source(Handle, Utf8.Bytes(body), place, axis, directivity));
        }

        /// <summary>The scene as one MJCF document, as MuJoCo will compile it.</summary>
        public string ToXml()
        {
            UIntPtr length;
            MimoException.Check(Native.mimo_scene_xml(Handle, null, UIntPtr.Zero, out length));
            var text = new byte[(int)length + 1]; // and a zero
            MimoException.Check(Native.mimo_scene_xml(Handle, text, (UIntPtr)text.Length, out length));
            return Encoding.UTF8.GetString(text, 0, (int)length);
        }

        /// <summary>Writes the scene as scene.xml, with its textures and meshes in assets, for any program with MuJoCo.
        /// The folder is made where it is not there; files that are there with other content are not overwritten.</summary>
        public void Save(string folder)
        {
            MimoException.Check(Native.mimo_scene_save(Handle, Utf8.Bytes(folder)));
        }

        /// <summary>Adds a rigid object.</summary>
        public void AddObject(ObjectConfig config)
        {
            using (var parts = new PinnedParts())
            {
                var raw = Given.Some(config, "config", "an ObjectConfig").Raw(parts);
                MimoException.Check(Native.mimo_scene_add_object(Handle, ref raw));
            }
        }

        /// <summary>Has a camera observed; its fields come after those of all infants.</summary>
        public void AddCamera(CameraConfig config)
        {
            using (var parts = new PinnedParts())
            {
                var raw = Given.Some(config, "config", "a CameraConfig").Raw(parts);
                MimoException.Check(Native.mimo_scene_add_camera(Handle, ref raw));
            }
        }

        /// <summary>Has a quantity of parts of the scene observed, as a field of floats after those of all infants and cameras:
        /// "toys/position". Elements are names of bodies, joints, sites, sensors..., of agents "" for a sole one; null for the
        /// world's own. Positions, orientations, poses and velocities are relative to a body and move along with it; null: to
        /// the world.</summary>
        public void AddField(string name, Quantity quantity, string[] elements, string relativeTo = null)
        {
            using (var parts = new PinnedParts())
            {
                var config = FieldConfigStruct.New();
                config.name = parts.Text(name);
                config.quantity = (int)quantity;
                config.elements = parts.Keep(elements?.Select(parts.Text).ToArray());
                config.element_count = Given.LengthOrNone(elements);
                config.relative_to = parts.Text(relativeTo);
                MimoException.Check(Native.mimo_scene_add_field(Handle, ref config));
            }
        }

        /// <summary>Has an agent's proprioception read this hinge or slide; the first call takes away all others.</summary>
        public void ReadJoint(string joint, int agent = 0)
        {
            MimoException.Check(Native.mimo_scene_read_joint(Handle, Given.Index(agent, "agent"), Utf8.Bytes(joint)));
        }

        /// <summary>Limits a sense of an agent ("touch") or a field ("vision/eye_left"), for worlds made from now on: a factor,
        /// Gaussian noise of that standard deviation in the field's unit, a delay in seconds; pictures keep half the contrast
        /// of lines of blur cycles per degree; signalNoise is the deviation of further noise as a share of the value.</summary>
        public void LimitSense(string path, double gain = 1, double noise = 0, double delay = 0, double blur = 0, int agent = 0,
            double signalNoise = 0)
        {
            var limits = Limits(gain, noise, delay, signalNoise);
            limits.blur = blur;
            MimoException.Check(Native.mimo_scene_limit_sense(Handle, Given.Index(agent, "agent"), Utf8.Bytes(path), ref limits));
        }

        /// <summary>Limits the way of an agent's actions to a motor ("act:left_elbow"), to those of a part of its body
        /// ("left_arm"), or, with "", to all, for worlds made from now on: a factor, Gaussian noise of that standard deviation
        /// in the action's unit, a delay in seconds; signalNoise is the deviation of further noise as a share of the
        /// action.</summary>
        public void LimitMotor(string path, double gain = 1, double noise = 0, double delay = 0, int agent = 0,
            double signalNoise = 0)
        {
            var limits = Limits(gain, noise, delay, signalNoise);
            MimoException.Check(Native.mimo_scene_limit_motor(Handle, Given.Index(agent, "agent"), Utf8.Bytes(path), ref limits));
        }

        /// <summary>Gives an agent such eyes and nerves, for worlds made from now on; null: as its growth says. Limits take
        /// the place of these delays.</summary>
        public void SetMaturity(Maturity maturity, int agent = 0)
        {
            using (var parts = new PinnedParts())
            {
                var raw = maturity == null ? IntPtr.Zero : parts.Keep(new[] { maturity.Raw(parts) });
                MimoException.Check(Native.mimo_scene_set_maturity(Handle, Given.Index(agent, "agent"), raw));
            }
        }

        /// <summary>Sets how late an agent feels a part of its body ("left_hand"), by touch and by its joints, seconds; a body
        /// of null: all of it. It counts instead of what follows from its age.</summary>
        public void SetSensoryDelay(string body, double seconds, int agent = 0)
        {
            MimoException.Check(Native.mimo_scene_set_sensory_delay(Handle, Given.Index(agent, "agent"), Utf8.Bytes(body), seconds));
        }

        private static LimitsStruct Limits(double gain, double noise, double delay, double signalNoise)
        {
            var limits = LimitsStruct.New();
            limits.gain = gain;
            limits.noise = noise;
            limits.delay = delay;
            limits.signal_noise = signalNoise;
            return limits;
        }

        /// <summary>Sets the distance between the touch sensors of a body, "left_hand", metres; 0: no skin there; a body of
        /// null: everywhere.</summary>
        public void SetTouch(int agent, string body, double spacing)
        {
            MimoException.Check(Native.mimo_scene_set_touch(Handle, Given.Index(agent, "agent"), Utf8.Bytes(body), spacing));
        }

        /// <summary>Sets how warm the room is, -40 to 80 degrees Celsius: its air, and all that has no temperature of its
        /// own. Infants are as warm as skin in it.</summary>
        public void SetRoomTemperature(double celsius)
        {
            MimoException.Check(Native.mimo_scene_set_room_temperature(Handle, celsius));
        }

        /// <summary>Sets how warm a body of the model is, "cup", with all that hangs on it, degrees Celsius; it stays so.</summary>
        public void SetTemperature(string body, double celsius)
        {
            MimoException.Check(Native.mimo_scene_set_temperature(Handle, Utf8.Bytes(body), celsius));
        }

        /// <summary>Sets what a body of the model is made of, with all that hangs on it: one of Materials.Names.</summary>
        public void SetMaterial(string body, string material)
        {
            MimoException.Check(Native.mimo_scene_set_material(Handle, Utf8.Bytes(body), Utf8.Bytes(material)));
        }

        /// <summary>Gives worlds made from now on a task of your own in place of the scene's; null takes it away.</summary>
        public void SetTask(MimoTask task)
        {
            var before = Handle.Task;
            Handle.Task = Tasking.Tell(Handle, task);
            before?.Release();
        }

        /// <summary>Sets a parameter, one of Tasks.Parameters, "reach/success_reward", for worlds made from now on.</summary>
        public void SetParameter(string name, double value)
        {
            MimoException.Check(Native.mimo_scene_set_parameter(Handle, Utf8.Bytes(name), value));
        }

        /// <summary>The value that a parameter has in this scene.</summary>
        public double GetParameter(string name)
        {
            double value;
            MimoException.Check(Native.mimo_scene_get_parameter(Handle, Utf8.Bytes(name), out value));
            return value;
        }

        /// <summary>Frees the scene.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
