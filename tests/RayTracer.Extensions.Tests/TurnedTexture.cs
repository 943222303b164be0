using System.Numerics;
using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Extensions.Tests;

/// <summary>Describes the colour whose channels are the lengths of a turned axis along the axes of the world.</summary>
[SceneType("turned", "The colour of a direction.")]
public sealed record TurnedDescription : TextureDescription
{
    /// <summary>The rotation of the axis.</summary>
    [Parameter("Turns the axis.", Minimum = -1, Maximum = 1)]
    public Quaternion Turn { get; init; } = Quaternion.Identity;

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder)
    {
        Vector3 axis = Vector3.Abs(Vector3.Transform(Vector3.UnitX, Turn));
        return new SolidTexture(new(axis.X, axis.Y, axis.Z));
    }
}
