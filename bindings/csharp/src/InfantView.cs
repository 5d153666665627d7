using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>Makes and updates an engine's object for each visible geom of a world. Implement it with the engine's
    /// own classes, pass it to an InfantView, call Build once and Update after steps.</summary>
    public interface IDrawer
    {
        /// <summary>Adds a texture. Appearances refer to it by its id.</summary>
        void AddTexture(int id, MimoTexture texture);

        /// <summary>Adds a geom with its name in the model and its body's name, or changes its shape.</summary>
        void SetMesh(int geom, string name, string body, MimoMesh mesh);

        /// <summary>Sets a geom's appearance. Invisible geoms must be hidden.</summary>
        void SetAppearance(int geom, Appearance appearance);

        /// <summary>Moves a geom.</summary>
        void SetPose(int geom, float x, float y, float z, float qx, float qy, float qz, float qw);
    }

    /// <summary>Keeps an engine's objects in step with the geoms of a world.</summary>
    public sealed class InfantView
    {
        private readonly Env env;
        private readonly IDrawer drawer;
        private readonly Axes axes;
        private readonly int segments;
        private readonly float[] poses;
        private readonly Appearance[] shown;
        private readonly HashSet<int> textures = new HashSet<int>();

        /// <summary>Makes a view of a world for a drawer and an engine's frame: Axes.Unity, Unreal, Godot or
        /// Gltf.</summary>
        public InfantView(Env env, IDrawer drawer, Axes axes = Axes.Unity, int segments = 24)
        {
            if (axes == Axes.Mimo) throw new ArgumentException("axes is Mimo, expected an engine's frame", nameof(axes));
            this.env = Given.Some(env, "env", "an Env");
            this.drawer = Given.Some(drawer, "drawer", "an IDrawer");
            this.axes = axes;
            this.segments = segments;
            var count = env.Count(Kind.Geom);
            poses = new float[7 * count];
            shown = new Appearance[count];
        }

        /// <summary>Passes all meshes, appearances and poses to the drawer. Call it at the start and after sizes of
        /// geoms or ages of infants have changed.</summary>
        public void Build()
        {
            for (var geom = 0; geom < shown.Length; ++geom)
            {
                var body = env.Name(Kind.Body, env.BodyOf(Kind.Geom, geom));
                drawer.SetMesh(geom, env.Name(Kind.Geom, geom), body, env.Mesh(geom, axes, segments));
                Show(geom, env.Appearance(geom));
            }
            Update();
        }

        /// <summary>Moves all visible geoms to their current poses. Allocates nothing.</summary>
        public void Update()
        {
            env.Poses(Kind.Geom, axes, poses);
            for (var geom = 0; geom < shown.Length; ++geom)
            {
                if (!shown[geom].Visible) continue;
                var i = 7 * geom;
                drawer.SetPose(geom, poses[i], poses[i + 1], poses[i + 2], poses[i + 3], poses[i + 4], poses[i + 5],
                    poses[i + 6]);
            }
        }

        /// <summary>Passes changed appearances to the drawer, for example after a change of face or colour.</summary>
        public void UpdateMaterials()
        {
            for (var geom = 0; geom < shown.Length; ++geom)
            {
                var appearance = env.Appearance(geom);
                if (!appearance.Equals(shown[geom])) Show(geom, appearance);
            }
        }

        private void Show(int geom, Appearance appearance)
        {
            if (appearance.Visible && appearance.Texture >= 0 && textures.Add(appearance.Texture))
                drawer.AddTexture(appearance.Texture, env.Texture(appearance.Texture));
            shown[geom] = appearance;
            drawer.SetAppearance(geom, appearance);
        }
    }
}
