namespace RayTracer.RenderTests.Oracle;

/// <summary>What is rendered.</summary>
internal sealed class Scene
{
    public required Camera Camera { get; init; }

    public required int Width { get; init; }

    public required int Height { get; init; }

    public required int MaxDiffuseDepth { get; init; }

    public required int MaxSpecularDepth { get; init; }

    public required Vec Background { get; init; }

    public required Vec Ambient { get; init; }

    /// <summary>All shapes, lights included.</summary>
    public required Shape[] Shapes { get; init; }

    /// <summary>Those of the shapes that shine.</summary>
    public required Shape[] Lights { get; init; }
}
