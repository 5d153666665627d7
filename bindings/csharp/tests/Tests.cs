// Tests of the C# binding: a program that runs all tests and prints how many passed. Mono has no test runner.
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using Mimo;

internal static partial class Tests
{
    private static void Check(bool good, string what)
    {
        if (!good) throw new Exception(what);
    }

    private static void Near(double expected, double value, double tolerance, string what)
    {
        Check(Math.Abs(expected - value) <= tolerance, what + ": " + value + ", expected " + expected);
    }

    private static MimoException Refused(Action action)
    {
        try { action(); }
        catch (MimoException error) { return error; }
        throw new Exception("was not refused");
    }

    /// <summary>The layout of the structs in C# is the one in C.</summary>
    private static void StructsHaveTheLayoutOfC()
    {
        foreach (var one in Layouts)
        {
            var fields = one.Key.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
                .Select(field => field.Name + " " + Marshal.OffsetOf(one.Key, field.Name) + " " + Marshal.SizeOf(field.FieldType));
            var found = Marshal.SizeOf(one.Key) + ": " + string.Join(", ", fields);
            Check(found == one.Value, one.Key.Name + " is " + found + ", expected " + one.Value);
        }
    }

    private static void StructsAreBlittable()
    {
        foreach (var type in Layouts.Keys)
            GCHandle.Alloc(Activator.CreateInstance(type), GCHandleType.Pinned).Free(); // throws for other types
    }

    private static void ExceptionsHaveStatusAndMessage()
    {
        var error = Refused(() => new Env("benchmarc"));
        Check(error.Status == Status.NotFound && error.StatusName == "MIMO_E_NOT_FOUND", error.StatusName);
        Check(error.Message.Contains("\"benchmarc\""), error.Message);
        using (var env = new Env("reach"))
        {
            var action = new float[env.Layout.Actions.Count];
            action[1] = float.NaN;
            Check(Refused(() => env.Step(action)).Message == "action[1] is not a number", "another message");
        }
    }

    private static void DisposedWorldsAreRefused()
    {
        var env = new Env("reach");
        env.Dispose();
        env.Dispose();
        try { env.Step(null); }
        catch (ObjectDisposedException) { return; }
        throw new Exception("stepped after its end");
    }

    /// <summary>Semi-implicit Euler with h = 5 ms: after n steps a ball has fallen by g h^2 n (n + 1) / 2.</summary>
    private static void BallsFallAsCalculated()
    {
        using (var scene = MimoScene.Empty())
        {
            scene.AddObject(new ObjectConfig { Name = "ball", Position = new Vector3d(1, 2, 3) });
            using (var env = new Env(scene))
            {
                env.Reset(1);
                for (var i = 0; i < 10; ++i) env.Step(null);
                var joint = new double[7];
                env.Get(Quantity.JointPosition, new[] { 0 }, joint);
                var n = Math.Round(env.Time / 0.005);
                Check(n >= 10, "time stands still");
                Near(3 - 9.81 * 0.005 * 0.005 * n * (n + 1) / 2, joint[2], 1e-12, "height");
                Near(1, joint[0], 0, "x");
            }
        }
    }

    /// <summary>A turn to the left by 90 degrees turns forward to left in both frames.</summary>
    private static void LeftHandedFrameIsUnitys()
    {
        var right = LeftHanded.Position(new Vector3d(0, -1, 0));
        var up = LeftHanded.Position(new Vector3d(0, 0, 1));
        var ahead = LeftHanded.Position(new Vector3d(1, 0, 0));
        Check(right.X == 1 && right.Y == 0 && right.Z == 0, "right is x");
        Check(up.X == 0 && up.Y == 1 && up.Z == 0, "up is y");
        Check(ahead.X == 0 && ahead.Y == 0 && ahead.Z == 1, "ahead is z");
        var half = Math.Sqrt(0.5);
        var turned = Rotate(LeftHanded.Rotation(new Quaterniond(half, 0, 0, half)), ahead);
        Near(-1, turned.X, 1e-15, "to the left");
    }

    private static void RightHandedFrameIsGodots()
    {
        var right = RightHanded.Position(new Vector3d(0, -1, 0));
        var up = RightHanded.Position(new Vector3d(0, 0, 1));
        var ahead = RightHanded.Position(new Vector3d(1, 0, 0));
        Check(right.X == 1 && up.Y == 1 && ahead.Z == -1, "x right, y up, -z ahead");
        var half = Math.Sqrt(0.5);
        Near(-1, Rotate(RightHanded.Rotation(new Quaterniond(half, 0, 0, half)), ahead).X, 1e-15, "to the left");
        Commutes(RightHanded.Position, RightHanded.Rotation);
    }

    private static void ConversionCommutesWithRotation() { Commutes(LeftHanded.Position, LeftHanded.Rotation); }

    /// <summary>Conversion and rotation commute, for any rotation and point.</summary>
    private static void Commutes(Func<Vector3d, Vector3d> position, Func<Quaterniond, Quaterniond> rotation)
    {
        var random = new Random(1);
        for (var i = 0; i < 100; ++i)
        {
            Func<double> any = () => 2 * random.NextDouble() - 1;
            var q = new Quaterniond(any(), any(), any(), any());
            var norm = Math.Sqrt(q.W * q.W + q.X * q.X + q.Y * q.Y + q.Z * q.Z);
            q = new Quaterniond(q.W / norm, q.X / norm, q.Y / norm, q.Z / norm);
            var p = new Vector3d(any(), any(), any());
            var one = position(Rotate(q, p));
            var other = Rotate(rotation(q), position(p));
            Near(one.X, other.X, 1e-14, "x");
            Near(one.Y, other.Y, 1e-14, "y");
            Near(one.Z, other.Z, 1e-14, "z");
        }
    }

    /// <summary>v + 2 w (u x v) + 2 u x (u x v): the same formula in left- and right-handed frames.</summary>
    private static Vector3d Rotate(Quaterniond q, Vector3d v)
    {
        var u = new Vector3d(q.X, q.Y, q.Z);
        var a = Cross(u, v);
        var b = Cross(u, a);
        return new Vector3d(v.X + 2 * (q.W * a.X + b.X), v.Y + 2 * (q.W * a.Y + b.Y), v.Z + 2 * (q.W * a.Z + b.Z));
    }

    private static Vector3d Cross(Vector3d a, Vector3d b)
    {
        return new Vector3d(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
    }

    private static void PicturesAndPoses()
    {
        using (var env = new Env("benchmark"))
        {
            env.Reset(7);
            var eye = env.Layout.Find("vision/eye_left");
            Check(eye.Shape.SequenceEqual(new[] { 256, 256, 3 }), "the default size");
            byte[] rgb = new byte[eye.Bytes], up = new byte[256 * 256 * 4], down = new byte[256 * 256 * 4];
            env.Read(eye, rgb);
            env.ReadRgba(eye, down);
            env.ReadRgba(eye, up, true);
            for (var i = 0; i < 3; ++i)
            {
                Check(down[4 * 1000 + i] == rgb[3 * 1000 + i], "top row first");
                Check(up[4 * (255 * 256 + 7) + i] == rgb[3 * 7 + i], "bottom row first");
            }
            Check(down[3] == 255 && rgb.Distinct().Count() > 10, "an opaque picture of something");
            var poses = new PoseReader(env);
            poses.Read();
            var place = new double[3];
            var head = env.Find(Kind.Body, "head");
            env.Get(Quantity.BodyPosition | Quantity.Now, new[] { head }, place);
            Near(place[2], poses.Poses[head].Y, 1e-6, "the head's height");
            Near(-place[1], poses.Poses[head].X, 1e-6, "to the right");
        }
    }

    /// <summary>Prints the messages for a user whose library is missing or of another version.</summary>
    private static int SayWhyNothingOpens()
    {
        Console.WriteLine(Refused(() => new Env("reach")).Message);
        Console.WriteLine(Refused(() => MimoScene.Empty()).Message);
        Console.WriteLine(Refused(() => Faces.Names.ToString()).Message);
        return 0;
    }

    /// <summary>All tests: the methods without parameters and result.</summary>
    private static List<Action> All()
    {
        return typeof(Tests).GetMethods(BindingFlags.Static | BindingFlags.NonPublic)
            .Where(method => method.ReturnType == typeof(void) && method.GetParameters().Length == 0 && !method.Name.Contains("<"))
            .Select(method => (Action)Delegate.CreateDelegate(typeof(Action), method)).ToList();
    }

    /// <summary>Tests.exe --all runs the tests; without arguments it runs SayWhyNothingOpens; see AtTheEnd for the
    /// others.</summary>
    private static int Main(string[] arguments)
    {
        if (arguments.Length == 0) return SayWhyNothingOpens();
        if (arguments[0].StartsWith("--end")) return AtTheEnd(arguments[0], arguments[1]);
        var tests = All();
        var failed = 0;
        foreach (var test in tests)
        {
            try { test(); }
            catch (Exception error)
            {
                ++failed;
                Console.WriteLine("FAILED " + test.Method.Name + ": " + error.Message);
            }
        }
        Console.WriteLine("C#: " + (tests.Count - failed) + " passed, " + failed + " failed");
        return failed == 0 ? 0 : 1;
    }
}
