using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>The changes that a scene makes to the triangles of a mesh: flat or smooth, turned inside out, with other uv.</summary>
internal static class MeshVariant
{
    /// <summary>True where nothing changes.</summary>
    public static bool IsOwn(MeshDescription wanted) =>
        wanted is { Shading: MeshShading.Own, FlipNormals: false, FlipV: false, IgnoreColors: false, ColorAttribute: "", SecondColorAttribute: "", Refinement.MovesCorners: false };

    /// <summary>The triangles as they are wanted; the same ones where they are.</summary>
    public static MeshData Of(MeshData mesh, MeshDescription wanted)
    {
        if (IsOwn(wanted))
        {
            return mesh;
        }

        Vector3[]? normals = wanted.Shading switch
        {
            MeshShading.Flat => null,
            MeshShading.Smooth => mesh.Normals ?? SmoothNormals(mesh),
            _ => mesh.Normals,
        };
        MeshAttribute? first = mesh.Attributes.FirstOrDefault(a => a.Name == wanted.ColorAttribute);
        MeshAttribute? second = mesh.Attributes.FirstOrDefault(a => a.Name == wanted.SecondColorAttribute);
        MeshData variant = new(mesh.Positions, wanted.FlipNormals ? Turned(mesh.Indices) : mesh.Indices)
        {
            Normals = wanted.FlipNormals && normals is not null ? [.. normals.Select(n => -n)] : normals,
            Uv = wanted.FlipV && mesh.Uv is not null ? [.. mesh.Uv.Select(uv => new Vector2(uv.X, 1 - uv.Y))] : mesh.Uv,
            Colors = wanted.IgnoreColors ? null : first is { IsOfTriangles: false } ? first.Values : mesh.Colors,
            SecondColors = second is { IsOfTriangles: false } ? second.Values : null,
            Tangents = wanted.FlipV || wanted.FlipNormals ? null : mesh.Tangents,
            MaterialOfTriangle = mesh.MaterialOfTriangle,
            FaceOfTriangle = mesh.FaceOfTriangle,
        };
        Rgb[]? colors = first is { IsOfTriangles: true } ? first.Values : null;
        Rgb[]? others = second is { IsOfTriangles: true } ? second.Values : null;
        return (colors ?? others) is null ? variant : Apart(variant, colors, others);
    }

    // Triangles that share no corner, so that each has its colours.
    private static MeshData Apart(MeshData mesh, Rgb[]? colors, Rgb[]? others)
    {
        int count = int.Min(colors?.Length ?? int.MaxValue, others?.Length ?? int.MaxValue);
        int[] corners = [.. mesh.Indices.Where((_, i) => i / 3 < count)];
        T[]? Each<T>(T[]? values) => values is null ? null : [.. corners.Select(c => (uint)c < (uint)values.Length ? values[c] : default!)];
        bool AreThere(int triangle) => AreCorners(corners.AsSpan(3 * triangle, 3), mesh.Positions.Length);
        return new(Each(mesh.Positions)!, [.. Enumerable.Range(0, corners.Length).Select(i => AreThere(i / 3) ? i : int.MaxValue)])
        {
            Normals = Each(mesh.Normals),
            Uv = Each(mesh.Uv),
            Colors = colors is null ? Each(mesh.Colors) : [.. corners.Select((_, i) => colors[i / 3])],
            SecondColors = others is null ? Each(mesh.SecondColors) : [.. corners.Select((_, i) => others[i / 3])],
            Tangents = Each(mesh.Tangents),
            MaterialOfTriangle = mesh.MaterialOfTriangle,
        };
    }

    private static int[] Turned(int[] indices)
    {
        int[] turned = [.. indices];
        for (int i = 0; i + 2 < turned.Length; i += 3)
        {
            (turned[i + 1], turned[i + 2]) = (turned[i + 2], turned[i + 1]);
        }

        return turned;
    }

    /// <summary>
    /// The mean of the normals of the triangles around each corner, weighted by their angles there (Thürmer &amp; Wüthrich 1998).
    /// </summary>
    private static Vector3[] SmoothNormals(MeshData mesh)
    {
        Vector3[] normals = new Vector3[mesh.Positions.Length];
        for (int i = 0; i + 2 < mesh.Indices.Length; i += 3)
        {
            ReadOnlySpan<int> corners = mesh.Indices.AsSpan(i, 3);
            if (!AreCorners(corners, normals.Length))
            {
                continue;
            }

            for (int j = 0; j < 3; j++)
            {
                Vector3 at = mesh.Positions[corners[j]];
                Vector3 next = mesh.Positions[corners[(j + 1) % 3]] - at;
                Vector3 last = mesh.Positions[corners[(j + 2) % 3]] - at;
                Vector3 across = next.Cross(last);
                float angle = LaneMath.Atan2(across.Norm(), next.Dot(last));
                Vector3 weighted = across.Unit() * angle;
                normals[corners[j]] += weighted.IsFinite() ? weighted : default;
            }
        }

        return normals;
    }

    private static bool AreCorners(ReadOnlySpan<int> corners, int count) =>
        (uint)corners[0] < count && (uint)corners[1] < count && (uint)corners[2] < count;
}
