namespace RayTracer.Acceleration;

/// <summary>The primitives that a tree is built over. Asked from several threads at once.</summary>
internal interface IPrimitiveBounds
{
    /// <summary>Number of primitives.</summary>
    int Count { get; }

    /// <summary>The box of a primitive.</summary>
    /// <returns>False where the primitive can never be hit and stays out of the tree.</returns>
    bool TryGetBounds(int primitive, out Box4 box);
}
