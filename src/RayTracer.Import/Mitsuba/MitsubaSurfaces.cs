using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes the shapes that are no files, such that their uv are as theirs where something depends on it.</summary>
internal static class MitsubaSurfaces
{
    // Takes our sphere, around which u = ½ faces +z and whose pole is −y at v = 0, to theirs: pole +z at v = 0, u = 0 at +x. It mirrors.
    private static readonly Transform s_sphere = new(new(0, 0, -1, 0), new(-1, 0, 0, 0), new(0, -1, 0, 0));

    /// <summary>A shape of a type that is no file.</summary>
    public static ShapeDescription? Read(MitsubaObject shape, MaterialDescription material)
    {
        Transform place = shape.Transform();
        bool isTurned = shape.Boolean("flip_normals", false);
        bool needsUv = MaterialTextures.NeedUv(material);
        return shape.Type switch
        {
            "rectangle" => Rectangle(place, isTurned, material),
            "cube" => Cube(place, isTurned, needsUv, material),
            "disk" => Disk(place, isTurned, needsUv, material),
            "sphere" => Sphere(shape, place, isTurned, needsUv, material),
            _ => Cylinder(shape, place, isTurned, needsUv, material),
        };
    }

    // From −1 to 1 in x and y, with the front to +z. A map that mirrors turns the order of the corners, but not the front.
    private static ShapeDescription Rectangle(in Transform place, bool isTurned, MaterialDescription material)
    {
        if (place.Determinant > 0 == !isTurned)
        {
            return new RectangleDescription
            {
                Corner = place.Point(new(-1, -1, 0)),
                EdgeU = place.Vector(new(2, 0, 0)),
                EdgeV = place.Vector(new(0, 2, 0)),
                Material = material,
            };
        }

        Vector3[] corners = [new(-1, -1, 0), new(1, -1, 0), new(1, 1, 0), new(-1, 1, 0)];
        Transform map = place;
        return new MeshDescription
        {
            Positions = [.. corners.Select(c => map.Point(c))],
            Uv = [new(0, 0), new(1, 0), new(1, 1), new(0, 1)],
            Triangles = [new(0, 2, 1), new(0, 3, 2)],
            Material = material,
        };
    }

    private static ShapeDescription Cube(in Transform place, bool isTurned, bool needsUv, MaterialDescription material)
    {
        if (!isTurned && !needsUv)
        {
            return IsAlongAxes(place)
                ? new BoxDescription { A = place.Point(-Vector3.One), B = place.Point(Vector3.One), Material = material }
                : new BoxDescription { A = -Vector3.One, Material = material, Transform = MatrixSteps.Of(place) };
        }

        return CubeMesh.Create(needsUv) with { FlipNormals = isTurned, Material = material, Transform = MatrixSteps.Of(place) };
    }

    private static bool IsAlongAxes(in Transform place) => new[] { place.X, place.Y, place.Z }.All(r => new[] { r.A, r.B, r.C }.Count(n => n != 0) == 1);

    // Of radius 1, with the front to +z. Where uv matters, they are distance from the middle and angle.
    private static ShapeDescription Disk(in Transform place, bool isTurned, bool needsUv, MaterialDescription material)
    {
        if (needsUv)
        {
            material = MaterialTextures.Map(material, texture => Polar(texture, isTurned));
        }
        else if (place.UniformScale() is { } scale)
        {
            Vector3 normal = place.Inverse().TransposedVector(isTurned ? -Vector3.UnitZ : Vector3.UnitZ).Unit();
            return new DiskDescription { Center = place.Point(Vector3.Zero), Normal = normal, Radius = (float)scale, Material = material };
        }

        return new DiskDescription { Normal = isTurned ? -Vector3.UnitZ : Vector3.UnitZ, Material = material, Transform = MatrixSteps.Of(place) };
    }

    private static TextureDescription Polar(TextureDescription texture, bool isTurned)
    {
        PolarTextureDescription polar = new() { Texture = texture };
        return isTurned ? new PlacedTextureDescription { Texture = polar, Scale = new(-1, 1), Offset = new(1, 0) } : polar;
    }

    private static SphereDescription? Sphere(MitsubaObject shape, in Transform place, bool isTurned, bool needsUv, MaterialDescription material)
    {
        Vector3 center = shape.Vector("center") ?? Vector3.Zero;
        float radius = shape.Float("radius", 1);
        if (place.UniformScale() is not { } scale)
        {
            return shape.Log.Fail<SphereDescription>(shape.PlaceOf("to_world"), "a sphere that is scaled differently along its axes, or sheared, is not supported");
        }

        material = isTurned ? TurnedMaterials.Turned(shape, material) : material;

        return needsUv
            ? new() { Radius = radius, Material = material, Transform = MatrixSteps.Of(place * Transform.Translation(center) * s_sphere) }
            : new() { Center = place.Point(center), Radius = (float)(radius * scale), Material = material };
    }

    // A pipe without ends.
    private static CylinderDescription Cylinder(MitsubaObject shape, in Transform place, bool isTurned, bool needsUv, MaterialDescription material)
    {
        Vector3 bottom = shape.Vector("p0") ?? Vector3.Zero;
        Vector3 top = shape.Vector("p1") ?? Vector3.UnitZ;
        float radius = shape.Float("radius", 1);
        material = isTurned ? TurnedMaterials.Turned(shape, material) : material;

        if (!needsUv && place.UniformScale() is { } scale)
        {
            return new() { Bottom = place.Point(bottom), Top = place.Point(top), Radius = (float)(radius * scale), Caps = false, Material = material };
        }

        // Upright along z, our u = 0 is at −y, and theirs at +x.
        Transform upright = Transform.Translation(bottom) * Frame((top - bottom).Unit()) * Transform.Rotation(Vector3.UnitZ, -90);
        return new()
        {
            Top = new(0, 0, (top - bottom).Norm()),
            Radius = radius,
            Caps = false,
            Material = material,
            Transform = MatrixSteps.Of(place * upright),
        };
    }

    // The frame around a direction in which their angles count (Duff et al. 2017).
    private static Transform Frame(Vector3 n)
    {
        float sign = float.CopySign(1, n.Z);
        float a = -1 / (sign + n.Z);
        float b = n.X * n.Y * a;
        Vector3 s = new(1 + (sign * n.X * n.X * a), sign * b, -sign * n.X);
        Vector3 t = new(b, sign + (n.Y * n.Y * a), -n.Y);
        return new(new(s.X, t.X, n.X, 0), new(s.Y, t.Y, n.Y, 0), new(s.Z, t.Z, n.Z, 0));
    }
}
