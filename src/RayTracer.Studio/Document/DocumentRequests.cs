using System.Numerics;
using System.Text.Json;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>The bodies of the document's requests; see <see cref="DocumentEndpoints"/>.</summary>
internal static class DocumentRequests
{
    public sealed record Replace(int BaseRevision, int From, int To, string? Insert, string? Gesture);

    public sealed record Set(string? Pointer, JsonElement Value, string? Json, bool Reset, string? Gesture);

    public sealed record Add(string? Family, string? Type, string? File, Vector2? At);

    public sealed record Apply(string? Pointer, string[]? Things, Vector2? At);

    public sealed record At(string? Pointer);

    public sealed record Choice(string? Pointer, string[]? Pointers, bool Adds);

    public sealed record Many(string[]? Pointers);

    public sealed record Rename(string? Pointer, string? Name);

    public sealed record Place(string? Pointer, Vector3? Translate, Turn? Rotate, Vector3? Scale, Vector3? Center, string? Gesture);

    public sealed record Open(string? Path, string? GalleryId, string? RecoveryId, bool Discard);

    public sealed record New(bool Discard);

    public sealed record Save(string? Path, bool Overwrite);

    public sealed record Recovered(string? Id);
}
