using System;

namespace Mimo
{
    /// <summary>What to draw for people: a camera of the model, or a free one that by default sees the infant from the
    /// front.</summary>
    public sealed class PictureOptions
    {
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint Width = 640;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint Height = 480;
        /// <summary>Row 0 is the lowest, as in textures of Unity and OpenGL; otherwise it is the top.</summary>
        public bool BottomUp;
        /// <summary>A camera of the model; null: the free camera.</summary>
        public string Camera;
        /// <summary>Free camera: the point in the middle, world, m. Null: the default view, also of distance and angles.</summary>
        public Vector3d? LookAt;
        /// <summary>Free camera: from that point, m.</summary>
        public double Distance = 2;
        /// <summary>Free camera: degrees; 0 looks along x, 90 along y.</summary>
        public double Azimuth;
        /// <summary>Free camera: degrees; negative looks down.</summary>
        public double Elevation;
        /// <summary>Vertical field of view, degrees; 0: the camera's own.</summary>
        public double FieldOfView;
        /// <summary>Of colour: the middle is shown L / ln(1 + L) times as large, the rim small; 0: as drawn.</summary>
        public double Foveation;

        private const uint FourBytes = 1, LowestFirst = 2; // MIMO_PICTURE_RGBA, MIMO_PICTURE_BOTTOM_UP

        /// <summary>Calls a function with the C struct of these options, and checks what it answers.</summary>
        internal void Use(Func<PictureConfigStruct, int> call)
        {
            using (var camera = new PinnedText(Camera))
            {
                PictureConfigStruct config;
                MimoException.Check(Native.mimo_picture_config_init(out config, Structs.Size<PictureConfigStruct>()));
                config.width = Width;
                config.height = Height;
                config.format = FourBytes | (BottomUp ? LowestFirst : 0);
                config.camera = camera.Pointer;
                config.fovy = FieldOfView;
                config.foveation = Foveation;
                if (LookAt.HasValue)
                {
                    config.look_at = LookAt.Value;
                    config.distance = Distance;
                    config.azimuth = Azimuth;
                    config.elevation = Elevation;
                }
                MimoException.Check(call(config));
            }
        }
    }
}
