using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>Finds where things were in the picture before.</summary>
/// <param name="before">The camera then; null where nothing is known of it.</param>
/// <param name="camera">The camera now.</param>
/// <param name="moves">How the things have moved.</param>
internal readonly struct EarlierPlace(MovingCamera? before, MovingCamera? camera, ThingMoves moves)
{
    private readonly bool _isStill = !moves.HaveMoved && before is not null && camera?.IsAt(before) == true;

    /// <summary>Finds where what pixels of a row show was.</summary>
    /// <param name="x">The first pixel's column.</param>
    /// <param name="y">The row.</param>
    /// <param name="things">The things that are there.</param>
    /// <param name="now">The points that are seen.</param>
    /// <param name="across">The places in the earlier picture, as columns; a pixel's middle has its own.</param>
    /// <param name="down">The places as rows.</param>
    /// <param name="points">The points that the things had there then.</param>
    /// <returns>False for what was not in the picture.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MaskW Of(int x, int y, in UIntW things, in Vec3W now, out FloatW across, out FloatW down, out Vec3W points)
    {
        (across, down) = (FloatW.Iota + x, (float)y);
        points = moves.Before(things, now);
        if (_isStill)
        {
            return MaskW.All;
        }

        if (before is null || camera is null)
        {
            return MaskW.None;
        }

        // The sample's place within its pixel is none of the movement's.
        MaskW seen = before.Project(points, out FloatW thereX, out FloatW thereY) & camera.Project(now, out FloatW hereX, out FloatW hereY);
        (across, down) = (across + (thereX - hereX), down + (thereY - hereY));
        return seen;
    }
}
