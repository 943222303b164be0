using System.Collections.Immutable;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>What holds at a place of a scene, for what stands there (pbrt's graphics state).</summary>
internal sealed record PbrtState
{
    /// <summary>The maps from the space of what stands there to the world (before the camera: from the world to it).</summary>
    public PbrtPlaces Places { get; init; } = PbrtPlaces.World;

    /// <summary>The map where nothing moves, or at the first of the two times.</summary>
    public Transform Place => Places.Start;

    /// <summary>The times whose maps directives change.</summary>
    public PbrtTimes Active { get; init; } = PbrtTimes.All;

    /// <summary>The two times, in seconds.</summary>
    public (float Start, float End) Times { get; init; } = (0, 1);

    /// <summary>True where surfaces are turned inside out.</summary>
    public bool IsReversed { get; init; }

    /// <summary>The material; null for the usual one, or where <see cref="MaterialName"/> counts.</summary>
    public PbrtThing? Material { get; init; }

    /// <summary>The name of the material; empty where <see cref="Material"/> counts.</summary>
    public string MaterialName { get; init; } = "";

    /// <summary>The place of the name of the material.</summary>
    public SourcePlace MaterialPlace { get; init; }

    /// <summary>The light of surfaces; null where they do not shine.</summary>
    public PbrtThing? Light { get; init; }

    /// <summary>The name of the medium within shapes; empty for none.</summary>
    public string Inside { get; init; } = "";

    /// <summary>The name of the medium around them; empty for none.</summary>
    public string Outside { get; init; } = "";

    /// <summary>The colour space of numbers that are colours.</summary>
    public string ColorSpace { get; init; } = "srgb";

    /// <summary>What Attribute directives give things, by their kinds.</summary>
    public ImmutableList<(string Kind, PbrtParameter Parameter)> Attributes { get; init; } = [];
}
