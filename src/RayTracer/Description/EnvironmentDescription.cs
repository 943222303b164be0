using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Description;

/// <summary>Describes what surrounds a scene: light from infinitely far away, in all directions.</summary>
public abstract record EnvironmentDescription
{
    /// <summary>The rotation; empty for none.</summary>
    [Parameter("How the environment is turned: steps, the first one applied first. Moving it changes nothing, because it is infinitely far "
        + "away; stretching it is an error.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>The layer of light that has the environment's.</summary>
    [Parameter("The layer for the environment's light when lights are written as layers (--aov lights). Without it, the layer is called "
        + "environment.")]
    public string LightGroup { get; init; } = "";

    /// <summary>Makes the light that this record describes, or reports why it cannot be made and returns null.</summary>
    /// <param name="builder">Gives access to pictures and takes diagnostics.</param>
    public abstract EnvironmentLight? Build(SceneBuilder builder);

    /// <summary>
    /// Returns the rotation, as a map that scales all lengths by one factor; reports errors and then returns the identity.
    /// </summary>
    private protected Transform Turn(SceneBuilder builder)
    {
        Transform place = TransformSteps.Place(this, Transform, builder);
        if (place.UniformScale() is null)
        {
            builder.Error(this, nameof(Transform), "an environment can be turned and mirrored, but not stretched");
            return Numerics.Transform.Identity;
        }

        return place;
    }
}
