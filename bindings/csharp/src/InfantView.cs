using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>What an engine makes of a world: one object for each geom that is to be seen. The engine's own classes stay out of
    /// it: give it a drawer, call Build once and Update after steps.</summary>
    public interface IDrawer
    {
        /// <summary>A texture that appearances will name by its id.</summary>
        void AddTexture(int id, MimoTexture texture);

        /// <summary>A geom, with the name that it has in the model, and of its body; again after its shape has changed.</summary>
        void SetMesh(int geom, string name, string body, MimoMesh mesh);

        /// <summary>How it looks; again after that has changed. Invisible ones are to be hidden.</summary>
        void SetAppearance(int geom, Appearance appearance);

        /// <summary>Where it is.</summary>
        void SetPose(int geom, float x, float y, float z, float qx, float qy, float qz, float qw);
    }

    /// <summary>Keeps an engine's objects as the world's geoms are.</summary>
    public sealed class InfantView
    {
        private readonly Env env;
        private readonly IDrawer drawer;
        private readonly Axes axes;
        private readonly int segments;
        private readonly float[] poses;
        private readonly Appearance[] shown;
        private readonly HashSet<int> textures = new HashSet<int>();

        /// <summary>For a world, a drawer, and the engine's frame: Axes.Unity, Unreal, Godot or Gltf.</summary>
        public InfantView(Env env, IDrawer drawer, Axes axes = Axes.Unity, int segments = 24)
        {
            if (axes == Axes.Mimo) throw new ArgumentException("axes is Mimo, expected an engine's", nameof(axes));
            this.env = Given.Some(env, "env", "an Env");
            this.drawer = Given.Some(drawer, "drawer", "an IDrawer");
            this.axes = axes;
            this.segments = segments;
            var count = env.Count(Kind.Geom);
            poses = new float[7 * count];
            shown = new Appearance[count];
        }

        /// <summary>Hands over all meshes, appearances and poses: at the start, and after geoms were given another size or infants
        /// another age.</summary>
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

        /// <summary>Moves all that is to be seen to where it is now. Allocates nothing.</summary>
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

        /// <summary>Hands over appearances that have changed: another face, another colour.</summary>
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
