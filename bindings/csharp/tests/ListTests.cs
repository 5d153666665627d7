// Lists of names, and scenes as documents.
using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Mimo;

internal static partial class Tests
{
    private static void VersionsEqualTheHeader()
    {
        var version = Constants.VersionMajor + "." + Constants.VersionMinor + "." + Constants.VersionPatch + Constants.VersionLabel;
        Check(Library.Version == version, Library.Version);
        Check(Library.ApiVersion == Constants.ApiVersion, "API " + Library.ApiVersion);
        Check(Regex.IsMatch(Library.MuJoCoVersion, @"^2\.2\.\d+$"), Library.MuJoCoVersion); // the version of this build
    }

    private static void TheLibraryKnowsNames()
    {
        foreach (var name in new[] { "mimo_env_step", "MIMO_BODY_MASS", "mimo_field", "mimo_field.period" })
            Check(Library.Supports(name), name);
        Check(!Library.Supports("mimo_field.colour") && !Library.Supports(null), "names of nothing");
    }

    /// <summary>Numbers of a later version are Unsupported, not InvalidArgument.</summary>
    private static void UnknownNumbersAreUnsupported()
    {
        using (var env = new Env("reach"))
        {
            var error = Refused(() => env.Get((Quantity)0x270f));
            var known = Library.ApiVersion / 1000 + "." + Library.ApiVersion % 1000;
            Check(error.Status == Status.Unsupported && error.Message.Contains("0x270f") && error.Message.Contains(known), error.Message);
        }
    }

    /// <summary>Everything that is listed can be made.</summary>
    private static void ScenesRoomsAndTasksAreListed()
    {
        Check(Scenes.Names.Contains("reach") && Scenes.Names.Contains("playdate"), string.Join(" ", Scenes.Names));
        foreach (var name in Scenes.Names)
            using (MimoScene.Builtin(name)) { }
        Check(Rooms.Names.Contains("playroom"), string.Join(" ", Rooms.Names));
        foreach (var name in Rooms.Names)
            using (var scene = MimoScene.Empty()) scene.SetRoom(name);
        var tasks = new[] { "none", "reach", "standup", "selfbody", "catch", "rollover", "selftouch", "handregard", "behaviour" };
        Check(tasks.All(Tasks.Names.Contains), string.Join(" ", Tasks.Names));
        Check(Refused(() => MimoScene.Builtin("bench")).Message.Contains("benchmark"), "another message");
    }

    /// <summary>Reach's success is worth 100, as in the paper.</summary>
    private static void ParametersAreListed()
    {
        using (var scene = MimoScene.Builtin("reach"))
        {
            foreach (var one in Tasks.Parameters)
            {
                Check(Tasks.Names.Contains(one.Name.Split('/')[0]) && one.Description != "", one.Name);
                Check(one.Low <= one.Standard && one.Standard <= one.High, one.Name + " is out of its range");
                Check(scene.GetParameter(one.Name) == one.Standard, one.Name + " is not its standard");
                scene.SetParameter(one.Name, one.Low);
                Check(scene.GetParameter(one.Name) == one.Low, one.Name + " was not set");
                Refused(() => scene.SetParameter(one.Name, one.Low - 1));
                scene.SetParameter(one.Name, one.High);
                Refused(() => scene.SetParameter(one.Name, one.High + 1));
            }
            Check(Tasks.Parameters.Single(one => one.Name == "reach/success_reward").Standard == 100, "another reward");
            Check(Refused(() => scene.GetParameter("reach/luck")).Status == Status.NotFound, "another status");
        }
    }

    /// <summary>WHO's window of sitting without support: 3.8 to 9.2 months, for ten seconds.</summary>
    private static void BehavioursSayWhatTheyMeasure()
    {
        using (var scene = MimoScene.Builtin("sit"))
        {
            var sit = scene.Behaviour;
            Check(sit.Measure == "tilt upper_body z" && sit.Unit == "deg" && sit.HoldSeconds == 10, sit.Measure);
            Check(sit.NormEarly == 3.8 && sit.NormLate == 9.2 && sit.AtMost, "another norm");
        }
        using (var scene = MimoScene.Builtin("reach"))
            Check(Refused(() => { var none = scene.Behaviour; }).Status == Status.NotFound, "another status");
    }

    /// <summary>The same episode has the same movements.</summary>
    private static void InfantsMoveByThemselves()
    {
        using (var env = new Env("rollover"))
        {
            var one = new float[env.Layout.Actions.Count];
            var same = new float[one.Length];
            env.Reset(1);
            env.Spontaneous(one);
            env.Reset(1);
            env.Spontaneous(same);
            Check(one.Any(action => action != 0) && one.SequenceEqual(same), "other movements");
        }
    }

    /// <summary>A scene has the same mass after writing and reading it; names are UTF-8.</summary>
    private static void ScenesAreWritten()
    {
        using (var scene = MimoScene.Empty())
        {
            scene.AddObject(new ObjectConfig { Name = "Bällchen", Mass = 0.25, Position = new Vector3d(0, 0, 1) });
            using (var read = MimoScene.FromXml(scene.ToXml()))
            using (var env = new Env(read))
            {
                var mass = new double[1];
                env.Get(Quantity.BodyMass, new[] { env.Find(Kind.Body, "Bällchen") }, mass);
                Near(0.25, mass[0], 1e-12, "mass");
            }
        }
    }

    /// <summary>The config of mimo.h: eyes of 256 pixels, torques, a limit threshold of 0.035 rad.</summary>
    private static void DefaultAgentsAreMade()
    {
        var agent = new AgentConfig();
        Check(agent.Vision == Vision.Rgb && agent.VisionWidth == 256, "eyes");
        Check(agent.Actuation == Actuation.Torque && agent.LimitThreshold == 0.035, "defaults");
        agent.Vision = 0;
        agent.Touch = 0;
        using (var scene = MimoScene.Builtin("free"))
        {
            scene.AddAgent(agent);
            using (var env = new Env(scene)) Check(env.Layout.Agents == 1 && env.Find(Kind.Body, "head") > 0, "no infant");
        }
    }
}
