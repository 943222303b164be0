using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>
/// The corners of an OBJ file's meshes: each combination of position, uv and normal that faces name, once. Where faces name no normal but
/// belong to a smoothing group, the normal is the mean of the group's faces around the position, weighted by their areas (Gouraud 1971).
/// </summary>
internal sealed class ObjCorners
{
    /// <summary>Instead of a uv or a normal: there is none.</summary>
    public const int None = -1;

    // Instead of the number of a normal: of smooth normal i, this minus i.
    private const int FirstSmooth = -2;

    private readonly List<(int Position, int Uv, int Normal, int Next)> _corners = [];
    private readonly List<int> _firstOfPosition = []; // one more than the corner's number
    private readonly List<(Vector3 Sum, int Group, int Next)> _smooth = [];
    private readonly List<int> _firstSmooth = []; // one more than the smooth normal's number

    /// <summary>Number of corners.</summary>
    public int Count => _corners.Count;

    /// <summary>Position of a corner.</summary>
    public int PositionOf(int corner) => _corners[corner].Position;

    /// <summary>uv of a corner, or <see cref="None"/>.</summary>
    public int UvOf(int corner) => _corners[corner].Uv;

    /// <summary>The normal of a corner, of any length, from the file's normals or its smoothing group; zero where it has none.</summary>
    public Vector3 NormalOf(int corner, ReadOnlySpan<Vector3> normals)
    {
        int normal = _corners[corner].Normal;
        return normal >= 0 ? normals[normal] : normal == None ? default : _smooth[FirstSmooth - normal].Sum;
    }

    /// <summary>Adds a triangle's normal, as long as its area, to the smooth normals of its corners.</summary>
    public void AddNormal(int corner, Vector3 normal)
    {
        int number = FirstSmooth - _corners[corner].Normal;
        Span<(Vector3 Sum, int Group, int Next)> all = CollectionsMarshal.AsSpan(_smooth);
        all[number].Sum += normal;
    }

    /// <summary>The number of the corner of a combination.</summary>
    /// <param name="position">The position.</param>
    /// <param name="uv">The uv, or <see cref="None"/>.</param>
    /// <param name="normal">A normal, <see cref="None"/>, or what <see cref="Smooth"/> returns.</param>
    public int Find(int position, int uv, int normal)
    {
        ref int first = ref Entry(_firstOfPosition, position);
        for (int corner = first - 1; corner >= 0; corner = _corners[corner].Next)
        {
            (_, int cornerUv, int cornerNormal, _) = _corners[corner];
            if (cornerUv == uv && cornerNormal == normal)
            {
                return corner;
            }
        }

        _corners.Add((position, uv, normal, first - 1));
        first = _corners.Count;
        return first - 1;
    }

    /// <summary>The normal of a smoothing group at a position.</summary>
    public int Smooth(int position, int group)
    {
        ref int first = ref Entry(_firstSmooth, position);
        for (int normal = first - 1; normal >= 0; normal = _smooth[normal].Next)
        {
            if (_smooth[normal].Group == group)
            {
                return FirstSmooth - normal;
            }
        }

        _smooth.Add((default, group, first - 1));
        first = _smooth.Count;
        return FirstSmooth - (first - 1);
    }

    private static ref int Entry(List<int> list, int index)
    {
        if (index >= list.Count)
        {
            int size = Math.Max(index + 1, Math.Min(2 * list.Count, Array.MaxLength));
            CollectionsMarshal.SetCount(list, size);
        }

        return ref CollectionsMarshal.AsSpan(list)[index];
    }
}
