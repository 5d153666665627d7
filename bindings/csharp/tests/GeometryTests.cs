// Shapes, appearances and poses for engines.
using System;
using System.Collections.Generic;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    private static void MeshesHaveTheSizeOfTheirGeoms()
    {
        using (var env = new Env("benchmark"))
        {
            var head = env.Find(Kind.Geom, "head");
            var size = new double[3];
            env.Get(Quantity.GeomSize, new[] { head }, size);
            var mesh = env.Mesh(head, Axes.Unity);
            Check(mesh.Positions.Length == mesh.Normals.Length, "as many normals");
            Check(mesh.Positions.Length / 3 == mesh.Texcoords.Length / 2, "as many texture coordinates");
            Check(mesh.Indices.All(i => i >= 0 && i < mesh.Positions.Length / 3), "indices of vertices");
            var radii = Enumerable.Range(0, mesh.Positions.Length / 3)
                .Select(i => Math.Sqrt(mesh.Positions.Skip(3 * i).Take(3).Sum(x => (double)x * x))).ToList();
            Near(size[0], radii.Max(), 1e-6, "corners lie on the sphere");
            Check(radii.Min() > 0.98 * size[0], "and what lies between them within"); // 1 - cos(180 / 24 degrees) twice
            Check(Refused(() => env.Mesh(head, Axes.Unity, 6)).Message.Contains("segments is 6"), "another message");
            Check(env.Light(Env.Headlight).Directional, "the headlight");
        }
    }

    /// <summary>Unreal's unit is the centimetre, and its y axis points to the right.</summary>
    private static void PointsAreConverted()
    {
        var point = new float[] { 1, 2, 3 };
        Frames.ConvertPoints(Axes.Unreal, point);
        Check(point.SequenceEqual(new float[] { 100, -200, 300 }), "centimetres");
        var direction = new float[] { 1, 2, 3 };
        Frames.ConvertDirections(Axes.Unity, direction);
        Check(direction.SequenceEqual(new float[] { -2, 3, 1 }), "right, up, forward");
        var pose = new float[] { 1, 2, 3, 1, 0, 0, 0 };
        Frames.ConvertPoses(Axes.Unity, pose);
        Check(pose.SequenceEqual(new float[] { -2, 3, 1, 0, 0, 0, 1 }), "the scalar comes last");
    }

    /// <summary>Keeps everything it receives, as an engine would.</summary>
    private sealed class Memory : IDrawer
    {
        internal readonly Dictionary<int, MimoTexture> Textures = new Dictionary<int, MimoTexture>();
        internal readonly Dictionary<int, Appearance> Materials = new Dictionary<int, Appearance>();
        internal readonly Dictionary<int, float[]> Poses = new Dictionary<int, float[]>();
        internal readonly Dictionary<int, string> Bodies = new Dictionary<int, string>();
        internal int Triangles, Shown;

        public void AddTexture(int id, MimoTexture texture) { Textures.Add(id, texture); }
        public void SetMesh(int geom, string name, string body, MimoMesh mesh)
        {
            Bodies[geom] = body;
            Triangles += mesh.Indices.Length / 3;
        }
        public void SetAppearance(int geom, Appearance material)
        {
            ++Shown;
            Materials[geom] = material;
            Check(!material.Visible || material.Texture < 0 || Textures.ContainsKey(material.Texture), "a texture first");
        }
        public void SetPose(int geom, float x, float y, float z, float qx, float qy, float qz, float qw)
        {
            Poses[geom] = new[] { x, y, z, qx, qy, qz, qw };
        }
    }

    private static void ViewsFollowTheWorld()
    {
        using (var env = new Env("benchmark"))
        {
            env.Reset(1);
            var memory = new Memory();
            var view = new InfantView(env, memory);
            view.Build();
            var head = env.Find(Kind.Geom, "head");
            Check(memory.Bodies.Count == env.Count(Kind.Geom) && memory.Triangles > 1000, "all geoms");
            Check(memory.Bodies[head] == "head" && memory.Textures.Count > 3, "bodies and textures");
            for (var i = 0; i < 20; ++i) env.Step(null);
            view.Update();
            var place = new double[7];
            env.Get(Quantity.GeomPose | Quantity.Now, new[] { head }, place);
            Near(-place[1], memory.Poses[head][0], 1e-6, "right");
            Near(place[2], memory.Poses[head][1], 1e-6, "up");
            Near(place[0], memory.Poses[head][2], 1e-6, "forward");
            int shown = memory.Shown, before = memory.Materials[head].Texture;
            view.UpdateMaterials();
            Check(memory.Shown == shown, "nothing has changed");
            env.SetFace("surprise");
            view.UpdateMaterials();
            Check(memory.Shown == shown + 1 && memory.Materials[head].Texture != before, "another face");
        }
    }
}
