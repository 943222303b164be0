namespace RayTracer.Description;

/// <summary>Undoes a change of what a <see cref="SceneBuilder"/> takes for granted, at the end of a <c>using</c>.</summary>
internal readonly struct MaterialScope(Action undo) : IDisposable
{
    public void Dispose() => undo();
}
