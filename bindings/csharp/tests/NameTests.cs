// Names and numbers: those of mimo.h, and none that its users have already.
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Mimo;

internal static partial class Tests
{
    private static string headerFile;

    // Public types of the namespaces that scripts of an engine begin with (UnityEngine, UnityEngine.SceneManagement, .UI,
    // .Rendering, Unity.Mathematics, Godot, System.Numerics), as their manuals list them, without the long names of special
    // things. With a type of the same name of ours, a script that uses both namespaces does not compile (CS0104).
    private const string Taken =
        "AI AABB Action Animation AnimationClip AnimationCurve Animator AnimatorStateInfo Application Area2D Array AssetBundle " +
        "AsyncOperation AudioClip AudioListener AudioSource Avatar Basis Behaviour BoneWeight Bounds BoundsInt BoxCollider Button Cache Caching " +
        "Callable Camera Camera2D Camera3D Canvas CapsuleCollider CharacterController Cloth Collider Collision Color Color32 ColorUtility " +
        "CommandBuffer Complex Component ComputeBuffer ComputeShader ConfigurableJoint ContactFilter2D ContactPoint ContactPoint2D ContactPair " +
        "ContactPairHeader Control Coroutine Cubemap Cursor Debug Dictionary Display Engine Environment Error Event " +
        "FixedJoint Flare FlareLayer Font FrustumPlanes GameObject Gizmos GL Gradient Graphic Graphics Grid GUI GUILayout Gyroscope Handheld " +
        "Hash128 HideFlags HingeJoint HumanBone HumanPose HumanTrait Image Input Joint Joint2D JointDrive JointLimits JointMotor JointSpring " +
        "JsonUtility KeyCode Keyframe Label LayerMask LightProbes Light LightType LineRenderer LOD Lightmapping Material Mathf Matrix3x2 " +
        "Matrix4x4 Mesh MeshCollider MeshFilter MeshInstance3D MeshRenderer Microphone MonoBehaviour MonoPInvokeCallbackAttribute Motion Network Node Node2D Node3D " +
        "NodePath Object OS Outline ParticleSystem Physics Physics2D PhysicMaterial Ping Plane PlayerPrefs Polygon2D Pose Projection Projector " +
        "Profiler QualitySettings Quaternion QueryTriggerInteraction Random Range Ray Ray2D RaycastHit Rect Rect2 Rect2I RectInt RectOffset RectTransform " +
        "RefCounted ReflectionProbe Renderer RenderBuffer RenderMode RenderSettings RenderTexture Resolution Resource Resources RigidBody3D " +
        "Rigidbody RuntimeInitializeOnLoadMethodAttribute Scene SceneManager SceneTree SceneUtility LoadSceneMode Screen ScriptableObject Selectable Shader Shadow " +
        "Shape2D Shape3D Signal SkeletonBone Skeleton3D SkinnedMeshRenderer Skybox Slider Social Space SphereCollider Sprite SpriteRenderer StringName " +
        "SystemInfo Terrain Text TextAsset TextMesh Texture Texture2D Texture3D Time Timer Toggle Touch TouchPhase Transform Transform2D Transform3D Tree " +
        "Tween Variant Vector Vector2 Vector2I Vector2Int Vector3 Vector3I Vector3Int Vector4 Vector4I Viewport WaitForSeconds WheelCollider Window World " +
        "WindZone YieldInstruction bool3 double3 double4 float3 float4 int3 math quaternion";

    private static void NamesAreFree()
    {
        var taken = new HashSet<string>(Taken.Split(' '));
        var common = new[] { "System", "System.Collections.Generic", "System.Diagnostics", "System.IO", "System.Linq", "System.Threading" };
        foreach (var assembly in new[] { typeof(object).Assembly, typeof(Enumerable).Assembly, typeof(Uri).Assembly })
            taken.UnionWith(assembly.GetExportedTypes().Where(type => common.Contains(type.Namespace)).Select(type => type.Name));
        // Also what is not public: in Unity these sources are part of the scripts' own assembly.
        var ours = typeof(Env).Assembly.GetTypes().Where(type => type.Namespace == "Mimo" && !type.IsNested).Select(type => type.Name).ToList();
        Check(ours.Count > 20, "no types");
        var clashes = ours.Where(taken.Contains).ToList();
        Check(clashes.Count == 0, string.Join(" ", clashes));
    }

    /// <summary>JointPosition is MIMO_JOINT_POSITION.</summary>
    private static string HeaderName(string prefix, string name)
    {
        return prefix + Regex.Replace(name, "(?<=[a-z])(?=[A-Z])", "_").ToUpperInvariant();
    }

    private static void EnumsAreThoseOfTheHeader()
    {
        var header = File.ReadAllText(headerFile);
        var defined = Regex.Matches(header, @"#define (MIMO_\w+) (-?(?:0x)?[0-9a-f]+)u?\b").Cast<Match>()
            .ToDictionary(match => match.Groups[1].Value, match => ValueOf(match.Groups[2].Value));
        Action<Type, string, string> compare = (type, prefix, all) =>
        {
            var ours = Enum.GetNames(type).ToDictionary(name => HeaderName(prefix, name), name => Convert.ToInt64(Enum.Parse(type, name)));
            var theirs = defined.Where(one => Regex.IsMatch(one.Key, "^MIMO_(" + all + ")$")).ToDictionary(one => one.Key, one => one.Value);
            // Nothing at all is a name of ours where there it is just a 0.
            var differ = ours.Where(one => one.Value != 0 || theirs.ContainsKey(one.Key)).Except(theirs).Union(theirs.Except(ours))
                .Select(one => one.Key).Distinct().ToList();
            Check(theirs.Count > 1 && differ.Count == 0, type.Name + ": " + string.Join(" ", differ));
        };
        Check(defined["MIMO_ABI_VERSION"] == Library.Abi, "another ABI version");
        const string kinds = "BODY|JOINT|GEOM|SITE|CAMERA|ACTUATOR|SENSOR|LIGHT|CONTACT|STEP_CONTACT|AGENT|FACE|WORLD";
        compare(typeof(Kind), "MIMO_", kinds + "|WARNING");
        compare(typeof(Quantity), "MIMO_", "NOW|WARNING_COUNT|(?:" + kinds + ")_[A-Z_]+");
        compare(typeof(Status), "MIMO_E_", "E_[A-Z_]+");
        compare(typeof(MessageLevel), "MIMO_LOG_", "LOG_[A-Z]+");
        compare(typeof(Warning), "MIMO_WARNING_", "WARNING_(?!COUNT)[A-Z_]+");
        compare(typeof(Autoreset), "MIMO_AUTORESET_", "AUTORESET_[A-Z_]+");
        compare(typeof(Outcome), "MIMO_OUTCOME_", "OUTCOME_[A-Z]+");
        compare(typeof(Jacobian), "MIMO_JACOBIAN_", "JACOBIAN_[A-Z]+");
        compare(typeof(Disable), "MIMO_DISABLE_", "DISABLE_[A-Z_]+");
        compare(typeof(Render), "MIMO_RENDER_", "RENDER_[A-Z]+");
        compare(typeof(Shape), "MIMO_SHAPE_", "SHAPE_[A-Z]+");
        compare(typeof(Look), "MIMO_LOOK_", "LOOK_[A-Z]+");
        compare(typeof(FieldType), "MIMO_", "[UIF][0-9]+");
        compare(typeof(Receptor), "MIMO_RECEPTOR_", "RECEPTOR_[A-Z]+");
        compare(typeof(Place), "MIMO_PLACE_", "PLACE_[A-Z]+");
        compare(typeof(Proprioception), "MIMO_PROPRIOCEPTION_", "PROPRIOCEPTION_[A-Z_]+");
        compare(typeof(Vestibular), "MIMO_VESTIBULAR_", "VESTIBULAR_[A-Z_]+");
        compare(typeof(Vision), "MIMO_VISION_", "VISION_[A-Z]+");
        compare(typeof(Actuation), "MIMO_ACTUATION_", "ACTUATION_[A-Z_]+");
        compare(typeof(Act), "MIMO_ACT_", "ACT_[A-Z_]+");
        compare(typeof(TouchOutputs), "MIMO_TOUCH_", "TOUCH_[A-Z_0-9]+");
        compare(typeof(TouchResponse), "MIMO_RESPONSE_", "RESPONSE_[A-Z]+");
        compare(typeof(TouchFrame), "MIMO_FRAME_", "FRAME_[A-Z]+");
    }

    private static long ValueOf(string number)
    {
        return number.StartsWith("0x") ? Convert.ToInt64(number.Substring(2), 16) : long.Parse(number);
    }

    /// <summary>A thing of every kind: each quantity has the width that mimo.h names.</summary>
    private static void EveryQuantityIsRead()
    {
        const string all = "<mujoco><worldbody><body name='arm' pos='0 0 1'><joint name='hinge' range='-1 1' limited='true'/>" +
            "<geom name='bone' size='.1'/><site name='mark'/><camera name='eye'/></body><light name='sun'/></worldbody>" +
            "<actuator><motor name='motor' joint='hinge' gear='3'/></actuator><sensor><accelerometer name='feel' site='mark'/></sensor></mujoco>";
        var names = new Dictionary<Kind, string>
        {
            { Kind.Body, "arm" }, { Kind.Joint, "hinge" }, { Kind.Geom, "bone" }, { Kind.Site, "mark" }, { Kind.Camera, "eye" },
            { Kind.Actuator, "motor" }, { Kind.Sensor, "feel" }, { Kind.Light, "sun" }, { Kind.Warning, "other" }
        };
        var widths = new[]
        {
            1, 1, 1, 1, 2, 3, 4, 6, 6, 1, 3, 3, 4, 3, 3, 4, 3, 4, 1, 1, 3, 1, 7, 7, 7, 7, 3, 4, 1, 2, 3, 3, 3, // then contacts
            2, 2, 3, 9, 1, 3, 3, 2, 2, 1, 1, 3, 3, 3, 1, 3, 1, 6, 0, 0, 1, 1, 1, 0 // agents have none here, nor do motors without spindles
        };
        using (var scene = MimoScene.FromXml(all))
        using (var env = new Env(scene, new EnvOptions { StepContacts = true }))
        {
            foreach (Quantity quantity in Enum.GetValues(typeof(Quantity)))
            {
                if (quantity == Quantity.Now) continue;
                var kind = names.Keys.SingleOrDefault(one => quantity.ToString().StartsWith(one.ToString()));
                if (kind == 0)
                {
                    var known = quantity == Quantity.WorldGravity ? 3 : 0; // there is nothing else of these: no contact, no agent
                    Check(env.Get(quantity).Length == known, quantity + " of all");
                    continue;
                }
                var id = new[] { env.Find(kind, names[kind]) };
                var width = widths[(int)quantity - 1];
                Check(env.Width(quantity, id) == width, quantity + " has " + env.Width(quantity, id) + " numbers");
                env.Get(quantity, id, new double[width]);
            }
            var gear = new double[1];
            env.Get(Quantity.ActuatorGear, new[] { 0 }, gear);
            Check(gear[0] == 3, "the gear");
        }
    }
}
