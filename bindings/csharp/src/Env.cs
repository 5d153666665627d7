using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>What a step gave, beside the observation.</summary>
    public struct Step
    {
        /// <summary>Reward of the task.</summary>
        public double Reward;
        /// <summary>The episode has ended by success or failure.</summary>
        public bool Terminated;
        /// <summary>The episode has reached its step limit.</summary>
        public bool Truncated;
    }

    /// <summary>A simulated world. One thread at a time, any thread. Its arrays are made once: a step allocates nothing.</summary>
    public sealed partial class Env : IDisposable
    {
        private readonly EnvHandle handle;
        private readonly double[] reward;
        private readonly byte[] terminated, truncated;
        private readonly ulong[] seedOf = new ulong[1];
        private readonly Dictionary<string, Field> byName = new Dictionary<string, Field>();

        /// <summary>The last observation: all fields, in one block. Overwritten by each reset, step and observe.</summary>
        public byte[] Block { get; }

        /// <summary>The fields of the block.</summary>
        public IReadOnlyList<Field> Fields { get; }

        /// <summary>Number of actions of all agents together.</summary>
        public int ActionSize { get; }

        /// <summary>Number of agents.</summary>
        public int AgentCount => reward.Length;

        /// <summary>A built-in scene by name with its own infant and task.</summary>
        public Env(string scene) : this(Make(scene)) { }

        /// <summary>Compiles a scene and makes a world of it.</summary>
        public Env(MimoScene scene, EnvOptions options = null) : this(Create(scene, options ?? new EnvOptions())) { }

        internal Env(EnvHandle made)
        {
            handle = made;
            UIntPtr bytes, fields, actions, agents;
            MimoException.Check(Native.mimo_env_observation_size(handle, out bytes, out fields));
            MimoException.Check(Native.mimo_env_action_size(handle, out actions));
            MimoException.Check(Native.mimo_env_agent_count(handle, out agents));
            Block = new byte[(int)bytes];
            ActionSize = (int)actions;
            reward = new double[(int)agents];
            terminated = new byte[(int)agents];
            truncated = new byte[(int)agents];
            Fields = ReadFields((int)fields);
        }

        private static EnvHandle Make(string scene)
        {
            Library.Require();
            EnvHandle made;
            MimoException.Check(Native.mimo_env_make(Utf8.Bytes(scene), out made));
            return made;
        }

        private static EnvHandle Create(MimoScene scene, EnvOptions options)
        {
            return options.Use((config, log) =>
            {
                EnvHandle made;
                var status = Native.mimo_env_create(scene.Handle, ref config, out made);
                made.Log = log;
                if (status != 0) log?.Release();
                MimoException.Check(status);
                made.Task = scene.Handle.Task?.Share();
                return made;
            });
        }

        private IReadOnlyList<Field> ReadFields(int count)
        {
            var fields = new Field[count];
            for (var i = 0; i < count; ++i)
            {
                var raw = new FieldStruct { struct_size = (uint)Structs.Size<FieldStruct>() };
                MimoException.Check(Native.mimo_env_observation_field(handle, (UIntPtr)i, ref raw));
                fields[i] = Field.Of(raw);
                byName[fields[i].Name] = fields[i];
            }
            return fields;
        }

        /// <summary>A field by its name.</summary>
        public Field FindField(string name)
        {
            Field field;
            if (byName.TryGetValue(name, out field)) return field;
            throw new KeyNotFoundException("no field named \"" + name + "\"; there are: " + string.Join(", ", byName.Keys));
        }

        /// <summary>Copies a field of the last observation into an array of its element type: byte, int, float or double.</summary>
        public void Read<T>(Field field, T[] into) where T : struct { field.CopyTo(into, Block, 0); }

        /// <summary>Copies a colour picture into RGBA bytes as engines want them: width x height x 4, opaque. bottomUp: the
        /// first row is the lowest, as in textures of Unity and OpenGL; otherwise it is the top.</summary>
        public void ReadRgba(Field picture, byte[] rgba, bool bottomUp = false)
        {
            int height = picture.Shape[0], width = picture.Shape[1];
            if (picture.Type != FieldType.U8 || rgba.Length < height * width * 4)
                throw new ArgumentException("needs " + height * width * 4 + " bytes", nameof(rgba));
            for (var row = 0; row < height; ++row)
            {
                var from = picture.Offset + row * width * 3;
                var to = (bottomUp ? height - 1 - row : row) * width * 4;
                for (var column = 0; column < width; ++column)
                {
                    rgba[to++] = Block[from++];
                    rgba[to++] = Block[from++];
                    rgba[to++] = Block[from++];
                    rgba[to++] = 255;
                }
            }
        }

        /// <summary>Starts an episode. Without a seed the world goes on with its own random numbers.</summary>
        public void Reset(ulong? seed = null)
        {
            seedOf[0] = seed.GetValueOrDefault();
            MimoException.Check(Native.mimo_env_reset(handle, seed.HasValue ? seedOf : null, Block, (UIntPtr)Block.Length));
        }

        /// <summary>Goes one step on; gives what the first agent got. Null leaves the controls as they are.</summary>
        public Step Step(float[] action)
        {
            MimoException.Check(Native.mimo_env_step(handle, action, (UIntPtr)(action == null ? 0 : action.Length), Block,
                (UIntPtr)Block.Length, reward, terminated, truncated, (UIntPtr)reward.Length));
            return reward.Length > 0 ? StepOf(0) : new Step();
        }

        /// <summary>What an agent got in the last step.</summary>
        public Step StepOf(int agent)
        {
            return new Step
            {
                Reward = reward[agent], Terminated = terminated[agent] != 0, Truncated = truncated[agent] != 0
            };
        }

        /// <summary>Observes the current state, without changing the trajectory.</summary>
        public void Observe()
        {
            MimoException.Check(Native.mimo_env_observe(handle, Block, (UIntPtr)Block.Length));
        }

        /// <summary>Simulated seconds since reset.</summary>
        public double Time
        {
            get
            {
                double seconds;
                MimoException.Check(Native.mimo_env_time(handle, out seconds));
                return seconds;
            }
        }

        /// <summary>Frees the world; one of a batch stays with the batch.</summary>
        public void Dispose() { handle.Dispose(); }
    }
}
