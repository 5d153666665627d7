// Pictures of plain arrays: distances and light that geometry gives.
using System;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    private static readonly double[] Upright = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    private const int Side = 65;

    /// <summary>A ball of half a metre above a floor 1 m below its middle.</summary>
    private static StageShapes BallAndFloor()
    {
        return new StageShapes
        {
            ObjectType = 5, Forms = new[] { (int)Form.Sphere, (int)Form.Plane }, Sizes = new[] { 0.5, 0, 0, 0, 0, 0 },
            Colors = Enumerable.Repeat(1f, 8).ToArray()
        };
    }

    private static StagePoses Places(double x)
    {
        return new StagePoses
        {
            GeomPositions = new[] { x, 0, 0, 0, 0, -1 }, GeomRotations = Upright.Concat(Upright).ToArray(),
            LightPositions = new[] { 0.0, 0, 9 }, LightDirections = new[] { Math.Sqrt(0.75), 0, -0.5 }
        };
    }

    private static StageView FromAbove(uint pose = 0)
    {
        return new StageView { Width = Side, Height = Side, Pose = pose, Position = new[] { 0.0, 0, 5 }, Rotation = Upright };
    }

    private static StageConfig Sunny()
    {
        var dim = new[] { 0.1f, 0.1f, 0.1f };
        return new StageConfig
        {
            Geoms = BallAndFloor(), Threads = 2, Air = new StageAir { Headlight = false },
            Lights = new StageLights
            {
                Types = new[] { (int)Lamp.Sun }, CastsShadow = new byte[] { 0 }, Ambient = dim,
                Diffuse = new[] { 0.8f, 0.8f, 0.8f }, Specular = new float[3]
            }
        };
    }

    private static void ABallOnAFloorIsWhereItIs()
    {
        using (var stage = new Stage(Sunny()))
        {
            var picture = stage.Draw(Places(0), FromAbove());
            const int middle = Side * Side / 2;
            Near(4.5, picture.Depth[middle], 1e-4, "the ball's upper side");
            Near(6, picture.Depth[0], 1e-4, "the floor");
            Check(picture.Segmentation[2 * middle] == 0 && picture.Segmentation[2 * middle + 1] == 5, "the ball");
            Check(picture.Segmentation[0] == 1, "the floor");
            Near(255 * (0.1 + 0.8 * 0.5), picture.Rgb[0], 1, "Lambert's law: .1 + .8 cos 60 degrees");
        }
    }

    private static void StagesChangeAndRefuse()
    {
        using (var stage = new Stage(Sunny()))
        {
            var geoms = BallAndFloor();
            geoms.Colors = new[] { 1f, 0, 0, 1, 1, 0, 0, 1 };
            stage.Update(new StageConfig { Geoms = geoms });
            var picture = stage.Draw(Places(0), FromAbove());
            Check(picture.Rgb[0] > 100 && picture.Rgb[1] == 0, "red");
            geoms.Colors = new float[7];
            try { stage.Update(new StageConfig { Geoms = geoms }); Check(false, "refused"); }
            catch (ArgumentException error) { Check(error.Message.Contains("StageShapes.Colors"), "the array is named"); }
            var nowhere = Places(double.NaN);
            Check(Refused(() => stage.Draw(nowhere, FromAbove())).Message.Contains("geom_positions[0, 0] is"), "the place is named");
        }
    }

    private static void ManyPicturesAreThoseOfOneEach()
    {
        using (var stage = new Stage(Sunny()))
        {
            var poses = Enumerable.Range(0, 3).Select(i => Places(0.2 * i)).ToArray();
            var views = Enumerable.Range(0, 3).Select(i => FromAbove((uint)i)).ToArray();
            var pictures = views.Select(_ => new StagePicture { Rgb = new byte[3 * Side * Side] }).ToArray();
            stage.Draw(poses, views, pictures);
            for (var i = 0; i < 3; ++i)
                Check(pictures[i].Rgb.SequenceEqual(stage.Draw(poses[i], FromAbove()).Rgb), "picture " + i);
            Check(!pictures[0].Rgb.SequenceEqual(pictures[1].Rgb), "the ball moves");
        }
    }
}
