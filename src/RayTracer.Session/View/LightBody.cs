using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>What a handle of a light changes.</summary>
public enum LightHandleKind
{
    /// <summary>Where it shines.</summary>
    Direction,

    /// <summary>How wide a spot's cone is.</summary>
    Cone,

    /// <summary>How wide the part of the cone is that has the full strength.</summary>
    Beam,

    /// <summary>How large a lamp is.</summary>
    Radius,
}

/// <summary>A light as it is drawn over the picture: lights that no ray meets would not be seen otherwise.</summary>
/// <param name="Pointer">The light in the text.</param>
/// <param name="Kind">Its type: point, spot, directional, sun, or area for a lamp that is seen itself.</param>
/// <param name="Place">The place of its icon in the picture, in pixels.</param>
/// <param name="Lines">Its outline.</param>
/// <param name="Handles">Where it can be taken hold of.</param>
public sealed record LightBody(
    string Pointer, string Kind, Vector2 Place, IReadOnlyList<IReadOnlyList<Vector2>> Lines, IReadOnlyList<LightHandle> Handles)
{
    // Arrows and cones are as long as this part of the picture's height.
    private const float Length = 0.25f;

    /// <summary>All lights of a scene that the camera can see something of.</summary>
    public static IReadOnlyList<LightBody> Of(ViewportScene shown)
    {
        JsonText text = JsonText.Of(shown.Good.Read);
        CameraFrame camera = CameraFrame.Of(shown);
        return [.. SceneValue.Scene(text.Root).WithInner().Where(v => IsBodied(v) && !shown.Good.Hidden.Any(h => Picking.IsWithin(v.Pointer, h))).Select(v => LightPose.Of(text, v, shown)).OfType<LightPose>()
            .Select(pose => Of(pose, camera)).OfType<LightBody>()];
    }

    /// <summary>Returns whether a light at a pointer has a place of its own, which can be moved.</summary>
    internal static bool IsBodied(SceneValue value) => value.Node is not null
        && (value.Type?.Create() is PunctualLightDescription or SkyEnvironmentDescription
            || (value.Pointer.StartsWith("/lights/", StringComparison.Ordinal) && value.Type?.Find("radius") is not null));

    /// <summary>The length of a light's arrow at its place, in scene units.</summary>
    internal static float Reach(CameraFrame camera, Vector3 place) => camera.LengthOf(Length * camera.Height, place);

    private static LightBody? Of(LightPose pose, CameraFrame camera)
    {
        Vector3 foot = pose.Position ?? (camera.LookAt - (pose.Direction!.Value * Reach(camera, camera.LookAt)));
        if (camera.Project(foot) is not { } place)
        {
            return null;
        }

        float reach = Reach(camera, foot);
        List<Vector3[]> lines = [];
        List<LightHandle?> handles = [];
        if (pose.Direction is { } along)
        {
            Vector3 tip = foot + (along * reach);
            lines.Add([foot, tip]);
            handles.Add(Handle(LightHandleKind.Direction, pose.Position is null ? foot : tip));
            AddCone(LightHandleKind.Cone, pose.Cone);
            AddCone(LightHandleKind.Beam, pose.Beam);
        }

        if (pose.Radius is { } radius)
        {
            Vector3 across = camera.Forward.Cross(camera.Up).Unit();
            lines.Add(WireLines.Circle(foot, across, camera.Up, radius));
            handles.Add(Handle(LightHandleKind.Radius, foot + (across * radius)));
        }

        return new(pose.Pointer, pose.Kind, place, [.. lines.SelectMany(Seen)], [.. handles.OfType<LightHandle>()]);

        LightHandle? Handle(LightHandleKind kind, Vector3 at) => camera.Project(at) is { } pixel ? new(kind, pixel) : null;

        IEnumerable<Vector2[]> Seen(Vector3[] line)
        {
            Vector2?[] points = [.. line.Select(camera.Project)];
            return points.All(p => p is not null) ? [[.. points.Select(p => p!.Value)]] : [];
        }

        void AddCone(LightHandleKind kind, float? degrees)
        {
            if (degrees is not { } angle)
            {
                return;
            }

            LaneMath.SinCosTurn(angle / 360, out float sin, out float cos);
            (Vector3 u, Vector3 v) = WireLines.Across(along);
            Vector3 middle = foot + (along * (cos * reach));
            Vector3 across = Side(camera, along, u) * (sin * reach);
            lines.Add(WireLines.Circle(middle, u, v, sin * reach));
            lines.Add([middle + across, foot, middle - across]);
            handles.Add(Handle(kind, middle + (kind == LightHandleKind.Cone ? across : -across)));
        }
    }

    /// <summary>The direction in which a cone's edge is seen, to the right of the camera where there are two.</summary>
    private static Vector3 Side(CameraFrame camera, Vector3 along, Vector3 otherwise)
    {
        Vector3 side = along.Cross(camera.Forward);
        side = side.Norm() > 1e-3f ? side.Unit() : otherwise;
        return side.Dot(camera.Right) < 0 ? -side : side;
    }
}

/// <summary>Where a light can be taken hold of.</summary>
/// <param name="Kind">What it changes.</param>
/// <param name="At">Its place in the picture, in pixels.</param>
public sealed record LightHandle(LightHandleKind Kind, Vector2 At);

/// <summary>A light's place in the world.</summary>
/// <param name="Pointer">The light in the text.</param>
/// <param name="Kind">Its type.</param>
/// <param name="Space">From its own space to the world.</param>
/// <param name="Position">Where it is; null where it is infinitely far away.</param>
/// <param name="Direction">The unit direction in which its light travels; null for all.</param>
/// <param name="Cone">The angle between the direction and the edge of a spot's cone, in degrees.</param>
/// <param name="Beam">The same of its beam.</param>
/// <param name="Radius">The radius of a lamp, in the world.</param>
internal sealed record LightPose(
    string Pointer, string Kind, Transform Space, Vector3? Position, Vector3? Direction = null, float? Cone = null, float? Beam = null, float? Radius = null)
{
    /// <summary>That of a place in a text; null where there is no light with a body.</summary>
    /// <param name="text">The text.</param>
    /// <param name="value">The place.</param>
    /// <param name="shown">The picture at whose time it is meant; null for as it is written.</param>
    public static LightPose? Of(JsonText text, SceneValue value, ViewportScene? shown = null)
    {
        object record = Shown(value, shown?.Good.Read.Description) ?? value.Record();
        if (record is SkyEnvironmentDescription sky)
        {
            return sky.SunScale > 0 ? new(value.Pointer, "sun", Transform.Identity, null, -Sun(sky)) : null;
        }

        double? time = shown?.Good.Frame is { } frame ? FrameTimes.TimeOf(frame, FrameTimes.Rate(text.Root)) : null;
        Transform space = ShapePlacement.SpaceAt(text.Root, value.Pointer, time);
        Vector3 middle = space.Point(((ShapeDescription)record).Middle);
        return record switch
        {
            PointLightDescription => new(value.Pointer, "point", space, middle),
            SpotLightDescription spot => new(
                value.Pointer, "spot", space, middle, space.Vector(spot.Direction).Unit(), spot.CutoffAngle, spot.BeamWidth ?? (0.75f * spot.CutoffAngle)),
            DirectionalLightDescription sun => new(value.Pointer, "directional", space, null, space.Vector(sun.Direction).Unit()),
            ProjectorLightDescription projector => new(value.Pointer, "spot", space, middle, space.Vector(projector.Direction).Unit()),
            PunctualLightDescription => new(value.Pointer, "point", space, middle),
            _ => new(value.Pointer, "area", space, middle, Radius: value.Number("radius") * space.Vector(Vector3.UnitX).Norm()),
        };
    }

    // The record as it is at the time that is shown.
    private static object? Shown(SceneValue value, SceneDescription? scene) => JsonPointer.Parse(value.Pointer) switch
    {
        ["environment"] => scene?.Environment,
        ["lights", var step] when JsonPointer.Index(step) is >= 0 and var i && i < scene?.Lights.Count => scene.Lights[i],
        ["shapes", var step] when JsonPointer.Index(step) is >= 0 and var i && i < scene?.Shapes.Count => scene.Shapes[i],
        _ => null,
    };

    // Azimuth 0 is over −z, 90 over +x.
    private static Vector3 Sun(SkyEnvironmentDescription sky)
    {
        LaneMath.SinCosTurn(sky.SunElevation / 360, out float up, out float level);
        LaneMath.SinCosTurn(sky.SunAzimuth / 360, out float x, out float minusZ);
        return new(x * level, up, -minusZ * level);
    }
}
