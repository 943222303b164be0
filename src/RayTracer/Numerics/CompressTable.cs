using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Numerics;

/// <summary>For each of the 256 sets of eight lanes, the permutation that brings the set's lanes to the front in order.</summary>
internal static unsafe class CompressTable
{
    private static readonly int* s_permutations = Make();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> Permutation(uint set) => Vector256.Load(s_permutations + (set << 3));

    private static int* Make()
    {
        int* table = (int*)NativeMemory.AlignedAlloc(256 * 8 * sizeof(int), 64);
        for (int set = 0; set < 256; set++)
        {
            int* permutation = table + (8 * set);
            int filled = 0;
            for (int lane = 0; lane < 8; lane++)
            {
                if ((set >> lane & 1) != 0)
                {
                    permutation[filled++] = lane;
                }
            }

            new Span<int>(permutation + filled, 8 - filled).Clear();
        }

        return table;
    }
}
