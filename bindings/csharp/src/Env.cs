using System;

namespace Mimo
{
    /// <summary>A simulated world. Any thread may use it, one at a time. All arrays are made once: a step allocates
    /// nothing.</summary>
    public sealed partial class Env : IDisposable
    {
        private readonly EnvHandle owned;
        private readonly Results results;
        private EnvResultsStruct places;

        /// <summary>The last observation: one block with all fields. Each reset, step and observation overwrites
        /// it.</summary>
        public byte[] Block { get; }

        /// <summary>The world's observations, actions and reward terms.</summary>
        public Layout Layout { get; }

        /// <summary>The terms of the last step's rewards, in the order of Layout.Terms.</summary>
        public double[] Terms => results.Terms;

        /// <summary>Makes a world of a built-in scene with the scene's own infants and task.</summary>
        public Env(string scene) : this(Make(scene)) { }

        /// <summary>Compiles a scene and makes a world of it.</summary>
        public Env(MimoScene scene, EnvConfig config = null) : this(Create(scene, config ?? new EnvConfig())) { }

        internal Env(EnvHandle made) : this(made, LayoutOf(made)) { }

        internal Env(EnvHandle made, Layout layout)
        {
            owned = made;
            Layout = layout;
            Block = new byte[layout.BlockBytes];
            results = new Results(layout);
            places = results.PlaceIn(made.Kept);
        }

        private static Layout LayoutOf(EnvHandle made)
        {
            return new Layout(made, (out IntPtr layout) => Native.mimo_env_layout(made, out layout));
        }

        private static EnvHandle Make(string scene)
        {
            Library.Require();
            EnvHandle made;
            MimoException.Check(Native.mimo_env_make(Utf8.Bytes(scene), out made));
            return made;
        }

        private static EnvHandle Create(MimoScene scene, EnvConfig config)
        {
            return config.Use((raw, log) =>
            {
                EnvHandle made;
                var status = Native.mimo_env_create(Given.Some(scene, "scene", "a MimoScene").Handle, ref raw, out made);
                made.Log = log;
                Logging.CheckTold(status, log);
                made.Task = scene.Handle.Task?.Share();
                return made;
            });
        }

        /// <summary>Copies a field of the last observation into an array of its element type: byte, int, float or
        /// double.</summary>
        public void Read<T>(Field field, T[] into) where T : struct { Given.Some(field, "field", "one of Layout.Fields").CopyTo(into, Block, 0); }

        /// <summary>Copies a colour picture as opaque RGBA bytes, width x height x 4. With bottomUp the first row is
        /// the bottom one, as in textures of Unity and OpenGL; without it the first row is the top one.</summary>
        public void ReadRgba(Field picture, byte[] rgba, bool bottomUp = false)
        {
            if (Given.Some(picture, "picture", "one of Layout.Fields").Type != FieldType.U8)
                throw Given.Refusal("picture is " + picture.Name + ", expected a field with a colour picture");
            int height = picture.Shape[0], width = picture.Shape[1];
            if (rgba == null || rgba.Length < height * width * 4)
                throw Given.Misfit(rgba, nameof(rgba), "but " + picture.Name + " needs 4 bytes for each of " + width + " x " + height + " pixels");
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

        /// <summary>Starts an episode. Without a seed the world's random numbers continue. With a growth all infants of
        /// the world get that age and size.</summary>
        public void Reset(ulong? seed = null, Growth growth = null)
        {
            var config = ResetConfigStruct.Of(seed);
            using (var growths = new PinnedGrowths(growth == null ? null : new[] { growth }))
            {
                config.growth = growths.Pointer;
                config.growth_count = growths.Length;
                MimoException.Check(Native.mimo_env_reset(Handle, ref config, Block, (UIntPtr)Block.Length));
            }
            if (growth != null) Layout.Renew();
        }

        /// <summary>Steps the world and returns the first agent's result. Null keeps the controls.</summary>
        public Step Step(float[] action)
        {
            MimoException.Check(Native.mimo_env_step(Handle, action, Given.LengthOrNone(action), Block,
                (UIntPtr)Block.Length, ref places));
            return Layout.Agents > 0 ? StepOf(0) : new Step();
        }

        internal delegate int Move(EnvHandle env, byte[] block, ref EnvResultsStruct results);

        /// <summary>A step made by another function of the library.</summary>
        internal Step Take(Move move)
        {
            MimoException.Check(move(Handle, Block, ref places));
            return Layout.Agents > 0 ? StepOf(0) : new Step();
        }

        internal EnvHandle Handle => Ending.Pass(owned);

        /// <summary>An agent's result of the last step.</summary>
        public Step StepOf(int agent) { return results.Of(Given.Below(agent, Layout.Agents, "agent")); }

        /// <summary>Observes the current state. The trajectory does not change.</summary>
        public void Observe()
        {
            MimoException.Check(Native.mimo_env_observe(Handle, Block, (UIntPtr)Block.Length));
        }

        /// <summary>Simulated seconds since reset.</summary>
        public double Time
        {
            get
            {
                double seconds;
                MimoException.Check(Native.mimo_env_time(Handle, out seconds));
                return seconds;
            }
        }

        /// <summary>Destroys the world. A world of a batch stays with the batch.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
