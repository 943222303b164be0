using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// What rays have in common: the ranges of their origins and inverse directions. If these do not contain zero, one test of interval arithmetic
/// tells of a box that no ray meets (Boulos, Wald &amp; Shirley 2006).
/// </summary>
internal unsafe struct RayInterval
{
    private fixed float _inverse[6];
    private fixed float _nearShift[6];
    private fixed float _farShift[6];

    /// <summary>True where all rays point into the same octant; otherwise only <see cref="ByMajor"/> has a meaning.</summary>
    public bool SameOctant;

    /// <summary>Bits of the axes along which the rays run backwards.</summary>
    public int Octant;

    /// <summary>The rays that move fastest along each axis.</summary>
    public fixed ulong ByMajor[3];

    /// <summary>Finds what is common to the rays of a set, which is not empty.</summary>
    public void Enclose(RayBlock* rays, ulong set)
    {
        ByMajor[0] = ByMajor[1] = ByMajor[2] = 0;
        for (int lane = 0; lane < RayBlock.Size; lane += 8)
        {
            Vector256<int> majors = Vector256.Load(rays->Major + lane);
            for (int axis = 0; axis < 3; axis++)
            {
                ByMajor[axis] |= (ulong)Vector256.Equals(majors, Vector256.Create(axis)).ExtractMostSignificantBits() << lane & set;
            }
        }

        SameOctant = true;
        Octant = 0;
        for (int axis = 0; axis < 3; axis++)
        {
            EncloseAxis(rays, set, axis);
        }
    }

    /// <summary>Bounds the distances at which the rays cross planes: never after the first crossing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Enter(Vector256<float> planes, int axis) => Lanes8.Min(
        Lanes8.MultiplyAdd(planes, Vector256.Create(_inverse[2 * axis]), Vector256.Create(_nearShift[2 * axis])),
        Lanes8.MultiplyAdd(planes, Vector256.Create(_inverse[(2 * axis) + 1]), Vector256.Create(_nearShift[(2 * axis) + 1])));

    /// <summary>Bounds the distances at which the rays cross planes: never before the last crossing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Leave(Vector256<float> planes, int axis) => Lanes8.Max(
        Lanes8.MultiplyAdd(planes, Vector256.Create(_inverse[2 * axis]), Vector256.Create(_farShift[2 * axis])),
        Lanes8.MultiplyAdd(planes, Vector256.Create(_inverse[(2 * axis) + 1]), Vector256.Create(_farShift[(2 * axis) + 1])));

    /// <summary>The largest distance of the rays of a set.</summary>
    public static float Farthest(RayBlock* rays, ulong set)
    {
        Vector256<float> farthest = Vector256<float>.Zero;
        for (int lane = 0; set != 0; lane += 8, set >>= 8)
        {
            farthest = Lanes8.Max(Vector256.Load(rays->Distance + lane) & Lanes8.FromBits((uint)set), farthest);
        }

        return Lanes8.Largest(farthest);
    }

    private void EncloseAxis(RayBlock* rays, ulong set, int axis)
    {
        Vector256<float> infinity = Vector256.Create(float.PositiveInfinity);
        Vector256<float> leastInverse = infinity;
        Vector256<float> mostInverse = -infinity;
        Vector256<float> leastShift = infinity;
        Vector256<float> mostShift = -infinity;
        for (int lane = 0; set != 0; lane += 8, set >>= 8)
        {
            if ((set & 0xff) == 0)
            {
                continue;
            }

            Vector256<float> chosen = Lanes8.FromBits((uint)set);
            int at = (RayBlock.Size * axis) + lane;
            Vector256<float> inverse = Vector256.Load(rays->Inverse + at);
            Vector256<float> origin = Vector256.Load(rays->Origin + at);
            Vector256<float> slack = Vector256.Load(rays->Slack + lane) * RayBlock.BoxToTriangleSlack;
            leastInverse = Lanes8.Min(leastInverse, Vector256.ConditionalSelect(chosen, inverse, infinity));
            mostInverse = Lanes8.Max(mostInverse, Vector256.ConditionalSelect(chosen, inverse, -infinity));
            leastShift = Lanes8.Min(leastShift, Vector256.ConditionalSelect(chosen, origin - slack, infinity));
            mostShift = Lanes8.Max(mostShift, Vector256.ConditionalSelect(chosen, origin + slack, -infinity));
        }

        float least = Lanes8.Smallest(leastInverse);
        float most = Lanes8.Largest(mostInverse);
        bool backwards = most < 0f;
        SameOctant &= backwards || least > 0f;
        Octant |= backwards ? 1 << axis : 0;
        float lower = Lanes8.Smallest(leastShift);
        float upper = Lanes8.Largest(mostShift);
        float near = backwards ? lower : upper;
        float far = backwards ? upper : lower;
        _inverse[2 * axis] = least;
        _inverse[(2 * axis) + 1] = most;
        _nearShift[2 * axis] = -(near * least);
        _nearShift[(2 * axis) + 1] = -(near * most);
        _farShift[2 * axis] = -(far * least);
        _farShift[(2 * axis) + 1] = -(far * most);
    }
}
