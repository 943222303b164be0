using System.Collections.Immutable;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>What holds at a place of a scene, for what stands there (pbrt's graphics state).</summary>
internal sealed record PbrtState
{
    /// <summary>The map from the space of what stands there to the world (before the camera: from the world to it).</summary>
    public Transform Place { get; init; } = Transform.Identity;

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
