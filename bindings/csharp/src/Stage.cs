using System;
using System.Collections.Generic;

namespace Mimo
{
    public sealed partial class StageConfig
    {
        /// <summary>Threads that draw, 1 to 256; 0: 1.</summary>
        public int Threads { get; set; }
        /// <summary>Receives a warning for each thing that is not drawn, once.</summary>
        public Action<LogRecord> Log { get; set; }

        internal StageConfigStruct Raw(PinnedParts parts)
        {
            var filled = RawParts(parts);
            filled.threads = Given.Count(Threads, "Threads");
            return filled;
        }
    }

    public sealed partial class StageAir
    {
        /// <summary>Sets the colours of fog and haze: red, green, blue each.</summary>
        public void SetColors(float[] fog, float[] haze)
        {
            raw.fog_color = Rgb(fog, "fog");
            raw.haze_color = Rgb(haze, "haze");
        }

        /// <summary>Sets the parts of the headlight: red, green, blue each.</summary>
        public void SetHeadlight(float[] ambient, float[] diffuse, float[] specular)
        {
            raw.ambient = Rgb(ambient, "ambient");
            raw.diffuse = Rgb(diffuse, "diffuse");
            raw.specular = Rgb(specular, "specular");
        }

        private static Floats3 Rgb(float[] color, string name)
        {
            if (Given.Some(color, name, "three numbers").Length != 3) throw Given.Misfit(color, name, "expected three numbers");
            return new Floats3 { x = color[0], y = color[1], z = color[2] };
        }
    }

    public sealed partial class StageView
    {
        /// <summary>Where the camera is, m: three numbers.</summary>
        public double[] Position { get; set; }
        /// <summary>From the camera's frame (x right, y up, z backward) to the world's: nine numbers, row by row.</summary>
        public double[] Rotation { get; set; }

        internal StageViewStruct Raw(PinnedParts parts, StagePicture picture)
        {
            if (Given.Some(Position, "Position", "three numbers").Length != 3) throw Given.Misfit(Position, "Position", "expected three numbers");
            if (Given.Some(Rotation, "Rotation", "nine numbers").Length != 9) throw Given.Misfit(Rotation, "Rotation", "expected nine numbers");
            var filled = raw;
            filled.position = parts.Keep(Position);
            filled.rotation = parts.Keep(Rotation);
            filled.rgb = parts.Keep(picture.Rgb);
            filled.rgb_bytes = Given.LengthOrNone(picture.Rgb);
            filled.depth = parts.Keep(picture.Depth);
            filled.depth_count = Given.LengthOrNone(picture.Depth);
            filled.segmentation = parts.Keep(picture.Segmentation);
            filled.segmentation_count = Given.LengthOrNone(picture.Segmentation);
            return filled;
        }
    }

    /// <summary>The buffers of a picture, top row first. A null buffer is not drawn.</summary>
    public sealed class StagePicture
    {
        /// <summary>Red, green, blue of each pixel.</summary>
        public byte[] Rgb { get; set; }
        /// <summary>Metres along the camera's axis.</summary>
        public float[] Depth { get; set; }
        /// <summary>Id and type of each pixel's object, -1 -1 where nothing is.</summary>
        public int[] Segmentation { get; set; }
    }

    /// <summary>The length that arrays have in common, each of so many numbers.</summary>
    internal struct CommonLength
    {
        private readonly string owner;
        private string first;
        private int count;

        internal CommonLength(string owner)
        {
            this.owner = owner;
            first = null;
            count = 0;
        }

        internal UIntPtr Count => (UIntPtr)count;

        internal CommonLength Of(Array array, int width, string name)
        {
            if (array == null) return this;
            var own = array.Length / width;
            if (own * width != array.Length) throw Given.Misfit(array, owner + "." + name, "expected " + width + " numbers each");
            if (first != null && own != count) throw Given.Misfit(array, owner + "." + name, "but " + first + " is for " + count);
            first = name;
            count = own;
            return this;
        }
    }

    /// <summary>Things that plain arrays describe, drawn on the CPU without a simulation.</summary>
    public sealed class Stage : IDisposable
    {
        private readonly StageHandle owned;
        private StageHandle Handle => Ending.Pass(owned);

        /// <summary>Copies all arrays.</summary>
        public Stage(StageConfig config)
        {
            Library.Require();
            using (var parts = new PinnedParts())
            {
                var filled = Given.Some(config, "config", "a StageConfig").Raw(parts);
                var log = Logging.Tell(config.Log, out filled.log, out filled.log_user);
                var status = Native.mimo_stage_create(ref filled, out owned);
                owned.Log = log;
                Logging.CheckTold(status, log);
            }
        }

        /// <summary>Replaces the parts that are not null. Threads and Log stay as they are.</summary>
        public void Update(StageConfig change)
        {
            using (var parts = new PinnedParts())
            {
                var filled = Given.Some(change, "change", "a StageConfig").Raw(parts);
                MimoException.Check(Native.mimo_stage_update(Handle, ref filled));
            }
        }

        /// <summary>Draws one picture, into memory of its own.</summary>
        public StagePicture Draw(StagePoses poses, StageView view)
        {
            var pixels = checked((int)(Given.Some(view, "view", "a StageView").Width * view.Height));
            var picture = new StagePicture { Rgb = new byte[3 * pixels], Depth = new float[pixels], Segmentation = new int[2 * pixels] };
            Draw(new[] { poses }, new[] { view }, new[] { picture });
            return picture;
        }

        /// <summary>Draws many pictures, of many poses: each view says by number which of them it shows.</summary>
        public void Draw(IList<StagePoses> poses, IList<StageView> views, IList<StagePicture> pictures)
        {
            if (pictures.Count != views.Count) throw Given.Refusal("pictures has " + pictures.Count + " elements, but there are " + views.Count + " views");
            using (var parts = new PinnedParts())
            {
                var where = new IntPtr[poses.Count];
                for (var i = 0; i < where.Length; ++i) where[i] = parts.Keep(new[] { Given.Some(poses[i], "poses", "StagePoses").Raw(parts) });
                var seen = new IntPtr[views.Count];
                for (var i = 0; i < seen.Length; ++i) seen[i] = parts.Keep(new[] { views[i].Raw(parts, pictures[i]) });
                MimoException.Check(Native.mimo_stage_draw(Handle, where, (UIntPtr)where.Length, seen, (UIntPtr)seen.Length));
            }
        }

        /// <summary>Destroys the stage.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
