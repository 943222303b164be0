using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// The triangles of all meshes of one space, in its coordinates: corners, three indices a triangle, and what the corners carry. Rays
/// meet them through a tree; here the surface is described.
/// </summary>
internal sealed unsafe class MeshTable : SurfaceTable
{
    private readonly PinnedArray<Vector3> _positions;
    private readonly PinnedArray<int> _indices;
    private readonly PinnedArray<Vector3>? _normals;
    private readonly PinnedArray<Vector2>? _uv;
    private readonly PinnedArray<Rgb>? _colors;
    private readonly PinnedArray<Rgb>? _secondColors;
    private readonly PinnedArray<Vector4>? _tangents;

    private MeshTable(MeshData data)
        : base(data.TriangleCount, 1)
    {
        _positions = new(data.Positions);
        _indices = new(data.Indices);
        _normals = data.Normals is null ? null : new(data.Normals);
        _uv = data.Uv is null ? null : new(data.Uv);
        _colors = data.Colors is null ? null : new(data.Colors);
        _secondColors = data.SecondColors is null ? null : new(data.SecondColors);
        _tangents = data.Tangents is null ? null : new(data.Tangents);
    }

    /// <inheritdoc/>
    public override bool HasShadingNormals => _normals is not null;

    /// <inheritdoc/>
    public override bool HasTint => _colors is not null;

    /// <inheritdoc/>
    public override bool HasSecondTint => _secondColors is not null;

    /// <inheritdoc/>
    public override long MemoryBytes =>
        _positions.Bytes + _indices.Bytes + (_normals?.Bytes ?? 0) + (_uv?.Bytes ?? 0) + (_colors?.Bytes ?? 0) + (_secondColors?.Bytes ?? 0) + (_tangents?.Bytes ?? 0);

    /// <summary>The corners.</summary>
    public ReadOnlySpan<Vector3> Positions => _positions.Values;

    /// <summary>Three corners a triangle.</summary>
    public ReadOnlySpan<int> Indices => _indices.Values;

    /// <summary>Puts the meshes of a space into one table. The arrays of a mesh that is alone and where it was are not copied.</summary>
    /// <param name="meshes">At least one.</param>
    public static MeshTable Create(IReadOnlyList<PlacedMesh> meshes) =>
        new(meshes.Count == 1 && meshes[0].Place.IsIdentity ? meshes[0].Data : Merge(meshes));

    /// <summary>The box around a mesh's corners, used or not.</summary>
    public static Bounds BoundsOf(MeshData mesh)
    {
        Vector3 low = new(float.PositiveInfinity);
        Vector3 high = new(float.NegativeInfinity);
        foreach (int corner in mesh.Indices)
        {
            low = Vector3.Min(low, mesh.Positions[corner]);
            high = Vector3.Max(high, mesh.Positions[corner]);
        }

        return new(low, high);
    }

    /// <summary>The corners of a triangle.</summary>
    public (Vector3 A, Vector3 B, Vector3 C) Corners(int triangle)
    {
        int* i = _indices.Pointer + (3L * triangle);
        return (_positions.Pointer[i[0]], _positions.Pointer[i[1]], _positions.Pointer[i[2]]);
    }

    /// <summary>uv of the corners of a triangle.</summary>
    public (Vector2 A, Vector2 B, Vector2 C) UvOf(int triangle)
    {
        int* i = _indices.Pointer + (3L * triangle);
        return _uv is null ? default : (_uv.Pointer[i[0]], _uv.Pointer[i[1]], _uv.Pointer[i[2]]);
    }

    /// <inheritdoc/>
    public override void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface)
    {
        uint* indices = (uint*)_indices.Pointer;
        UIntW first = primitives.Offset * 3u;
        UIntW.Gather(indices, first, out UIntW i, out UIntW j, out UIntW k);
        Vec3W a = Read(_positions.Pointer, i);
        Vec3W toB = Read(_positions.Pointer, j) - a;
        Vec3W toC = Read(_positions.Pointer, k) - a;

        // Scaled to about 1 before it is squared, so that triangles of every size have a normal.
        Vec3W normal = Vec3W.Cross(toB, toC);
        normal *= 1f / Largest(normal);
        FloatW length = FloatW.Sqrt(Vec3W.Dot(normal, normal));
        surface.Normal = normal * (1f / length);

        // The weights of the second and third corner, brought into the triangle where the point was rounded out of it.
        Vec3W from = surface.Point - a;
        FloatW inverse = 1f / Vec3W.Dot(Vec3W.Cross(toB, toC), surface.Normal);
        FloatW b = Clamp(Vec3W.Dot(Vec3W.Cross(from, toC), surface.Normal) * inverse, 1f);
        FloatW c = Clamp(Vec3W.Dot(Vec3W.Cross(toB, from), surface.Normal) * inverse, 1f - b);
        surface.Point = Vec3W.MultiplyAdd(toC, c, Vec3W.MultiplyAdd(toB, b, a));
        surface.Offset = (Largest(a) + FloatW.Max(Largest(toB), Largest(toC))) * RayOffset.Relative;

        if (_normals is not null)
        {
            DescribeShading(i, j, k, b, c, ref surface);
        }

        if (_colors is not null)
        {
            Vec3W tint = Mix(_colors.Pointer, i, j, k, b, c);
            surface.Tint = new(tint.X, tint.Y, tint.Z);
        }

        if (_secondColors is not null)
        {
            Vec3W tint = Mix(_secondColors.Pointer, i, j, k, b, c);
            surface.SecondTint = new(tint.X, tint.Y, tint.Z);
        }

        if (needsUv)
        {
            DescribeUv(i, j, k, b, c, ref surface);
        }
    }

    /// <inheritdoc/>
    public override void DescribeTangents(in PrimitiveIndex primitives, ref SurfaceW surface)
    {
        if (_uv is null)
        {
            surface.AlongU = surface.AlongV = new(0f, 0f, 0f);
            return;
        }

        uint* indices = (uint*)_indices.Pointer;
        float* uv = (float*)_uv.Pointer;
        UIntW first = primitives.Offset * 3u;
        UIntW.Gather(indices, first, out UIntW i, out UIntW j, out UIntW k);
        Vec3W a = Read(_positions.Pointer, i);
        Vec3W toB = Read(_positions.Pointer, j) - a;
        Vec3W toC = Read(_positions.Pointer, k) - a;
        FloatW.Gather(uv, i * 2u, out FloatW uA, out FloatW vA);
        FloatW.Gather(uv, j * 2u, out FloatW uB, out FloatW vB);
        FloatW.Gather(uv, k * 2u, out FloatW uC, out FloatW vC);
        (uB, uC, vB, vC) = (uB - uA, uC - uA, vB - vA, vC - vA);
        FloatW inverse = 1f / FloatW.NegatedMultiplyAdd(vB, uC, uB * vC);
        surface.AlongU = Vec3W.NegatedMultiplyAdd(toC, vB, toB * vC) * inverse;
        surface.AlongV = Vec3W.NegatedMultiplyAdd(toB, uC, toC * uB) * inverse;
    }

    private void DescribeShading(UIntW i, UIntW j, UIntW k, FloatW b, FloatW c, ref SurfaceW surface)
    {
        // Where corners have none, or theirs cancel out, the triangle is flat.
        Vec3W unit = Vec3W.Normalize(Mix(_normals!.Pointer, i, j, k, b, c));
        MaskW isGood = Vec3W.Dot(unit, unit) > 0.5f;
        surface.Shading = isGood.Select(unit, surface.Normal);
    }

    private void DescribeUv(UIntW i, UIntW j, UIntW k, FloatW b, FloatW c, ref SurfaceW surface)
    {
        if (_uv is null)
        {
            surface.U = surface.V = 0f;
            return;
        }

        float* uv = (float*)_uv.Pointer;
        FloatW a = 1f - b - c;
        FloatW.Gather(uv, i * 2u, out FloatW uA, out FloatW vA);
        FloatW.Gather(uv, j * 2u, out FloatW uB, out FloatW vB);
        FloatW.Gather(uv, k * 2u, out FloatW uC, out FloatW vC);
        surface.U = FloatW.MultiplyAdd(uC, c, FloatW.MultiplyAdd(uB, b, uA * a));
        surface.V = FloatW.MultiplyAdd(vC, c, FloatW.MultiplyAdd(vB, b, vA * a));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Largest(Vec3W v) => FloatW.Max(FloatW.Abs(v.X), FloatW.Max(FloatW.Abs(v.Y), FloatW.Abs(v.Z)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Clamp(FloatW x, FloatW most) => FloatW.Min(FloatW.Max(x, 0f), most);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vec3W Read(void* table, UIntW index) => Vec3W.Gather((float*)table, index * 3u);

    private static Vec3W Mix(void* table, UIntW i, UIntW j, UIntW k, FloatW b, FloatW c) =>
        Vec3W.MultiplyAdd(Read(table, k), c, Vec3W.MultiplyAdd(Read(table, j), b, Read(table, i) * (1f - b - c)));

    private static MeshData Merge(IReadOnlyList<PlacedMesh> meshes)
    {
        int corners = checked(meshes.Sum(m => m.Data.Positions.Length));
        Vector3[] positions = new Vector3[corners];
        int[] indices = new int[checked(meshes.Sum(m => m.Data.Indices.Length))];
        Vector3[]? normals = meshes.Any(m => m.Data.Normals is not null) ? new Vector3[corners] : null;
        Vector2[]? uv = meshes.Any(m => m.Data.Uv is not null) ? new Vector2[corners] : null;
        Rgb[]? colors = Whites(meshes, corners, d => d.Colors);
        Rgb[]? secondColors = Whites(meshes, corners, d => d.SecondColors);
        Vector4[]? tangents = meshes.Any(m => m.Data.Tangents is not null) ? new Vector4[corners] : null;
        (int corner, int index) = (0, 0);
        foreach (PlacedMesh mesh in meshes)
        {
            MeshData data = mesh.Data;
            (Transform place, int length) = (mesh.Place, data.Positions.Length);
            Transform inverse = place.Inverse();
            Map(data.Positions, positions, corner, place.Point);
            Map(data.Normals, normals, corner, NormalMap(place, inverse));
            data.Uv?.CopyTo(uv!, corner);
            data.Colors?.CopyTo(colors!, corner);
            data.SecondColors?.CopyTo(secondColors!, corner);
            Map(data.Tangents, tangents, corner, t => new Vector4(Unit(place.Vector(new(t.X, t.Y, t.Z))), t.W));

            // A map that mirrors changes the direction in which the corners go round.
            bool mirrors = place.Determinant < 0;
            for (int i = 0; i < data.Indices.Length; i += 3)
            {
                (indices[index + i], indices[index + i + 1], indices[index + i + 2]) =
                    (data.Indices[i] + corner, data.Indices[i + (mirrors ? 2 : 1)] + corner, data.Indices[i + (mirrors ? 1 : 2)] + corner);
            }

            corner += length;
            index += data.Indices.Length;
        }

        return new(positions, indices) { Normals = normals, Uv = uv, Colors = colors, SecondColors = secondColors, Tangents = tangents };
    }

    // Corners of meshes without colours are white where others have some.
    private static Rgb[]? Whites(IReadOnlyList<PlacedMesh> meshes, int corners, Func<MeshData, Rgb[]?> colors)
    {
        if (!meshes.Any(m => colors(m.Data) is not null))
        {
            return null;
        }

        Rgb[] whites = new Rgb[corners];
        Array.Fill(whites, Rgb.White);
        return whites;
    }

    // Where lengths change differently, normals keep the lengths that they come to: so those between corners are the same as of an instance, which
    // mixes them first and maps them then.
    private static Func<Vector3, Vector3> NormalMap(Transform place, Transform inverse)
    {
        if (place.UniformScale() is not null)
        {
            return n => Unit(inverse.TransposedVector(n));
        }

        float longest = new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ }.Max(axis => inverse.TransposedVector(axis).Norm());
        return n => inverse.TransposedVector(Unit(n)) / longest;
    }

    private static Vector3 Unit(Vector3 v) => v.Unit() is var unit && unit.IsFinite() ? unit : default;

    private static void Map<T>(T[]? from, T[]? to, int first, Func<T, T> map)
    {
        if (from is not null)
        {
            Parallel.For(0, (from.Length + 4095) / 4096, block =>
            {
                for (int i = block * 4096; i < Math.Min(from.Length, (block + 1) * 4096); i++)
                {
                    to![first + i] = map(from[i]);
                }
            });
        }
    }
}
