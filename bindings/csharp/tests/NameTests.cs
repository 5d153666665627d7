// Names of public types do not clash with engines; all quantities can be read.
using System;
using System.Collections.Generic;
using System.Linq;
using Mimo;

internal static partial class Tests
{
    // Public types of the namespaces that engine scripts use (UnityEngine, UnityEngine.SceneManagement, .UI, .Rendering,
    // Unity.Mathematics, Godot, System.Numerics), from their manuals, without long special names. If a type of the binding had
    // one of these names, a script that uses both namespaces would not compile (CS0104).
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

    private static void NamesDoNotClashWithEngines()
    {
        var taken = new HashSet<string>(Taken.Split(' '));
        var common = new[] { "System", "System.Collections.Generic", "System.Diagnostics", "System.IO", "System.Linq", "System.Threading" };
        foreach (var assembly in new[] { typeof(object).Assembly, typeof(Enumerable).Assembly, typeof(Uri).Assembly })
            taken.UnionWith(assembly.GetExportedTypes().Where(type => common.Contains(type.Namespace)).Select(type => type.Name));
        // Internal types count, too: in Unity these sources are part of the scripts' assembly.
        var ours = typeof(Env).Assembly.GetTypes().Where(type => type.Namespace == "Mimo" && !type.IsNested).Select(type => type.Name).ToList();
        Check(ours.Count > 20, "no types");
        var clashes = ours.Where(taken.Contains).ToList();
        Check(clashes.Count == 0, string.Join(" ", clashes));
    }

    /// <summary>Reads every quantity in a model with one thing of each kind.</summary>
    private static void AllQuantitiesAreRead()
    {
        const string all = "<mujoco><worldbody><body name='arm' pos='0 0 1'><joint name='hinge' range='-1 1' limited='true'/>" +
            "<geom name='bone' size='.1'/><site name='mark'/><camera name='eye'/></body><light name='sun'/></worldbody>" +
            "<actuator><motor name='motor' joint='hinge' gear='3'/></actuator><sensor><accelerometer name='feel' site='mark'/></sensor></mujoco>";
        var names = new Dictionary<Kind, string>
        {
            { Kind.Body, "arm" }, { Kind.Joint, "hinge" }, { Kind.Geom, "bone" }, { Kind.Site, "mark" }, { Kind.Camera, "eye" },
            { Kind.Actuator, "motor" }, { Kind.Sensor, "feel" }, { Kind.Light, "sun" }, { Kind.Warning, "other" }
        };
        using (var scene = MimoScene.FromXml(all))
        using (var env = new Env(scene, new EnvConfig { StepContacts = true }))
        {
            foreach (Quantity quantity in Enum.GetValues(typeof(Quantity)))
            {
                if (quantity == Quantity.Now) continue;
                var kind = names.Keys.SingleOrDefault(one => quantity.ToString().StartsWith(one.ToString()));
                var ids = kind == 0 ? null : new[] { env.Find(kind, names[kind]) };
                env.Get(quantity, ids, new double[env.Width(quantity, ids)]);
            }
            Check(env.Get(Quantity.WorldGravity).Length == 3 && env.Get(Quantity.BodyPose).Length == 14, "gravity, and two bodies' poses");
            var gear = new double[1];
            env.Get(Quantity.ActuatorGear, new[] { 0 }, gear);
            Check(gear[0] == 3, "the gear");
        }
    }
}
