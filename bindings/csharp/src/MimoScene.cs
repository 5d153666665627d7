using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Mimo
{
    /// <summary>A description of a room, objects and infants. Worlds made from it do not need it afterwards.</summary>
    public sealed class MimoScene : IDisposable
    {
        private readonly SceneHandle owned;
        internal SceneHandle Handle => Ending.Pass(owned);

        private MimoScene(SceneConfig config, string name = null, string file = null, string xml = null)
        {
            Library.Require();
            owned = (config ?? new SceneConfig()).Make(name, file, xml);
        }

        /// <summary>Makes an empty scene.</summary>
        public static MimoScene Empty(SceneConfig config = null) { return new MimoScene(config); }

        /// <summary>Loads a built-in scene, one of Scenes.Names: "reach", "benchmark", ...</summary>
        public static MimoScene Builtin(string name, SceneConfig config = null)
        {
            return new MimoScene(config, name: Given.Text(name, "name", "the name of a built-in scene, one of Scenes.Names"));
        }

        /// <summary>Loads an MJCF file.</summary>
        public static MimoScene FromFile(string path, SceneConfig config = null)
        {
            return new MimoScene(config, file: Given.Text(path, "path", "the path of an MJCF file"));
        }

        /// <summary>Loads MJCF text.</summary>
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

        /// <summary>Adds all infants that the scene names, each at its own place, or a single infant if it names none.
        /// Returns their number. The config applies to all of them; its Name is only for scenes that name none, its
        /// place only for a single infant.</summary>
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

        /// <summary>Adds a room, one of Rooms.Names ("playroom"), to a scene without one.</summary>
        public void SetRoom(string name) { MimoException.Check(Native.mimo_scene_set_room(Handle, Utf8.Bytes(name))); }

        /// <summary>Adds an MJCF document with one body as an object, from a file or from text. All names in it get the
        /// object's name and '/' as a prefix.</summary>
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

        /// <summary>Fastens a body softly to another body, or to the world with null, in their relative pose at the
        /// scene's start.</summary>
        public void Weld(string body, string other = null)
        {
            MimoException.Check(Native.mimo_scene_weld(Handle, Utf8.Bytes(body), Utf8.Bytes(other), null));
        }

        /// <summary>Holds a hinge or slide softly at a position, rad or m, and starts it there.</summary>
        public void Lock(string joint, double value)
        {
            MimoException.Check(Native.mimo_scene_lock(Handle, Utf8.Bytes(joint), value));
        }

        /// <summary>Sets the start position of a hinge or slide, rad or m.</summary>
        public void SetPose(string joint, double value)
        {
            MimoException.Check(Native.mimo_scene_set_pose(Handle, Utf8.Bytes(joint), value));
        }

        /// <summary>Sets how many bodies can play sounds at once (default 4), and how many seconds of sound each can
        /// queue (default 4).</summary>
        public void SetSources(int count, double seconds)
        {
            MimoException.Check(Native.mimo_scene_set_sources(Handle, Given.Index(count, "count"), seconds));
        }

        /// <summary>Sets the position and axis of a body's sound source, in the body's frame. directivity: 0 in all
        /// directions alike, 0.5 a cardioid, 1 a figure of eight.</summary>
        public void DirectSource(string body, Vector3d place, Vector3d axis, double directivity)
        {
            MimoException.Check(Native.mimo_scene_direct_source(Handle, Utf8.Bytes(body), ref place, ref axis, directivity));
        }

        /// <summary>The scene as one MJCF document, as MuJoCo compiles it.</summary>
        public string ToXml()
        {
            UIntPtr length;
            MimoException.Check(Native.mimo_scene_xml(Handle, null, UIntPtr.Zero, out length));
            var text = new byte[(int)length + 1]; // with the terminating zero
            MimoException.Check(Native.mimo_scene_xml(Handle, text, (UIntPtr)text.Length, out length));
            return Encoding.UTF8.GetString(text, 0, (int)length);
        }

        /// <summary>Writes the scene as scene.xml with its textures and meshes in assets, for any program with MuJoCo.
        /// Makes the folder if it does not exist. Existing files with other content are not overwritten.</summary>
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

        /// <summary>Adds a camera's pictures to the observation. Their fields come after those of all agents.</summary>
        public void AddCamera(CameraConfig config)
        {
            using (var parts = new PinnedParts())
            {
                var raw = Given.Some(config, "config", "a CameraConfig").Raw(parts);
                MimoException.Check(Native.mimo_scene_add_camera(Handle, ref raw));
            }
        }

        /// <summary>Adds a quantity to the observation, as a field of floats after those of all agents and cameras, for
        /// example "toys/position". elements are names of bodies, joints, sites, sensors, ... or of agents ("" for a
        /// single one); null for quantities of the world. Positions, orientations, poses and velocities are in the
        /// frame of the body relativeTo, or in the world's with null.</summary>
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

        /// <summary>Makes an agent's proprioception read this hinge or slide. The first call removes all other
        /// joints.</summary>
        public void ReadJoint(string joint, int agent = 0)
        {
            MimoException.Check(Native.mimo_scene_read_joint(Handle, Given.Index(agent, "agent"), Utf8.Bytes(joint)));
        }

        /// <summary>Limits a sense of an agent ("touch") or a field ("vision/eye_left") in worlds made from now on.
        /// gain is a factor, noise the standard deviation of Gaussian noise in the field's unit, delay in seconds.
        /// blur: lines of that many cycles per degree keep half their contrast. signalNoise is the standard deviation
        /// of further noise as a share of the value.</summary>
        public void LimitSense(string path, double gain = 1, double noise = 0, double delay = 0, double blur = 0, int agent = 0,
            double signalNoise = 0)
        {
            var limits = Limits(gain, noise, delay, signalNoise);
            limits.blur = blur;
            MimoException.Check(Native.mimo_scene_limit_sense(Handle, Given.Index(agent, "agent"), Utf8.Bytes(path), ref limits));
        }

        /// <summary>Limits an agent's actions in worlds made from now on: those of a motor ("act:left_elbow"), of a
        /// part of the body ("left_arm"), or all with "". gain is a factor, noise the standard deviation of Gaussian
        /// noise in the action's unit, delay in seconds. signalNoise is the standard deviation of further noise as a
        /// share of the action.</summary>
        public void LimitMotor(string path, double gain = 1, double noise = 0, double delay = 0, int agent = 0,
            double signalNoise = 0)
        {
            var limits = Limits(gain, noise, delay, signalNoise);
            MimoException.Check(Native.mimo_scene_limit_motor(Handle, Given.Index(agent, "agent"), Utf8.Bytes(path), ref limits));
        }

        /// <summary>Sets the maturity of an agent's eyes and nerves in worlds made from now on; null uses its growth.
        /// LimitSense and LimitMotor override these delays.</summary>
        public void SetMaturity(Maturity maturity, int agent = 0)
        {
            using (var parts = new PinnedParts())
            {
                var raw = maturity == null ? IntPtr.Zero : parts.Keep(new[] { maturity.Raw(parts) });
                MimoException.Check(Native.mimo_scene_set_maturity(Handle, Given.Index(agent, "agent"), raw));
            }
        }

        /// <summary>Sets the delay, seconds, with which an agent feels a part of its body ("left_hand") by touch and
        /// joints; null sets it for the whole body. It overrides the delay of its age.</summary>
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

        /// <summary>Sets the spacing of the touch sensors of a body ("left_hand"), metres; 0: no skin. null sets it for
        /// all bodies.</summary>
        public void SetTouch(int agent, string body, double spacing)
        {
            MimoException.Check(Native.mimo_scene_set_touch(Handle, Given.Index(agent, "agent"), Utf8.Bytes(body), spacing));
        }

        /// <summary>Sets the temperature of the room, -40 to 80 degrees Celsius: of the air and of all things without a
        /// temperature of their own. Infants get the skin temperature of that room.</summary>
        public void SetRoomTemperature(double celsius)
        {
            MimoException.Check(Native.mimo_scene_set_room_temperature(Handle, celsius));
        }

        /// <summary>Sets the temperature of a body ("cup") and its child bodies, degrees Celsius. It is constant;
        /// contact does not change it.</summary>
        public void SetTemperature(string body, double celsius)
        {
            MimoException.Check(Native.mimo_scene_set_temperature(Handle, Utf8.Bytes(body), celsius));
        }

        /// <summary>Sets the material of a body and its child bodies, one of Materials.Names.</summary>
        public void SetMaterial(string body, string material)
        {
            MimoException.Check(Native.mimo_scene_set_material(Handle, Utf8.Bytes(body), Utf8.Bytes(material)));
        }

        /// <summary>Sets a custom task in place of the scene's, for worlds made from now on; null removes it.</summary>
        public void SetTask(MimoTask task)
        {
            var before = Handle.Task;
            Handle.Task = Tasking.Tell(Handle, task);
            before?.Release();
        }

        /// <summary>Gives an agent a sense of your own, for worlds made from now on. make is called for each world and
        /// agent. Raise the version when the memory changes its meaning.</summary>
        public void AddSense(string name, Func<SenseOpening, MimoSense> make, IEnumerable<SenseParameter> parameters = null, int agent = 0, int version = 0)
        {
            Sensing.Tell(name, make, parameters, version,
                (ref SenseStruct raw) => Native.mimo_scene_add_sense(Handle, Given.Index(agent, "agent"), ref raw));
        }

        /// <summary>The same for a sense in a shared library, whose code runs: load only what you trust.</summary>
        public void LoadSense(string path, int agent = 0)
        {
            MimoException.Check(Native.mimo_scene_load_sense(Handle, Given.Index(agent, "agent"), Utf8.Bytes(path)));
        }

        /// <summary>The parameters of all senses of your own, for SetParameter.</summary>
        public IReadOnlyList<Parameter> SenseParameters
        {
            get
            {
                var all = new List<Parameter>();
                for (;;)
                {
                    var raw = ParameterStruct.New();
                    var status = Native.mimo_scene_sense_parameter(Handle, (UIntPtr)all.Count, ref raw);
                    if (status == (int)Status.NotFound) return all;
                    MimoException.Check(status);
                    all.Add(new Parameter(raw));
                }
            }
        }

        /// <summary>Sets a task's parameter, one of Tasks.Parameters ("reach/success_reward"), or one of a sense of your
        /// own ("ct/rate", SenseParameters), for worlds made from now on.</summary>
        public void SetParameter(string name, double value)
        {
            MimoException.Check(Native.mimo_scene_set_parameter(Handle, Utf8.Bytes(name), value));
        }

        /// <summary>The value of a parameter in this scene.</summary>
        public double GetParameter(string name)
        {
            double value;
            MimoException.Check(Native.mimo_scene_get_parameter(Handle, Utf8.Bytes(name), out value));
            return value;
        }

        /// <summary>What the infant is to do, of a scene whose task is "behaviour".</summary>
        public MimoBehaviour Behaviour
        {
            get
            {
                var raw = BehaviourStruct.New();
                MimoException.Check(Native.mimo_scene_behaviour(Handle, ref raw));
                return new MimoBehaviour(raw);
            }
        }

        /// <summary>Destroys the scene.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
