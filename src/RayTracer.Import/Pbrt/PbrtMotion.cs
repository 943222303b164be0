using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>The maps of what stands somewhere, at the two times between which it moves (pbrt's set of current transforms).</summary>
/// <param name="Start">From its space to the world at the first time, and before.</param>
/// <param name="End">At the second, and after.</param>
internal readonly record struct PbrtPlaces(Transform Start, Transform End)
{
    /// <summary>Those of what stands in the world itself.</summary>
    public static PbrtPlaces World { get; } = new(Transform.Identity, Transform.Identity);

    /// <summary>True where they differ.</summary>
    public bool Moves => Start != End;

    /// <summary>Each of the two changed.</summary>
    public PbrtPlaces Select(Func<Transform, Transform> change) => new(change(Start), change(End));
}

/// <summary>The times whose transforms directives change.</summary>
[Flags]
internal enum PbrtTimes
{
    /// <summary>The first.</summary>
    StartTime = 1,

    /// <summary>The second.</summary>
    EndTime = 2,

    /// <summary>Both.</summary>
    All = StartTime | EndTime,
}

/// <summary>Makes motions: as here, places and scales change in proportion to time, and rotations at constant speed.</summary>
internal static class PbrtMotion
{
    /// <summary>The keyframes of a thing; none where it rests.</summary>
    /// <param name="thing">The thing.</param>
    /// <param name="places">Its places.</param>
    public static IReadOnlyList<KeyframeDescription> Of(PbrtThing thing, in PbrtPlaces places)
    {
        if (!places.Moves)
        {
            return [];
        }

        (float first, float second) = thing.State.Times;
        if (!(first < second))
        {
            thing.Log.Error(thing.Place, $"what moves needs times that rise (TransformTimes), but they are {first} and {second}");
            return [];
        }

        return [new() { Time = first, Transform = MatrixSteps.Of(places.Start) }, new() { Time = second, Transform = MatrixSteps.Of(places.End) }];
    }
}
