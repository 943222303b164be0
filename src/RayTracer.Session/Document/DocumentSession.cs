namespace RayTracer.Session;

/// <summary>The document side of a session: one document, and all that is done with it but looking at it.</summary>
public sealed class DocumentSession : IDisposable
{
    /// <summary>Begins with a new scene.</summary>
    /// <param name="folders">The user's folders; null for those of the process's user.</param>
    /// <param name="scenes">The folder of the shipped scenes; null for the one that comes with the program.</param>
    /// <param name="time">The clock.</param>
    public DocumentSession(UserFolders? folders = null, string? scenes = null, TimeProvider? time = null)
    {
        folders ??= UserFolders.OfUser();
        Document = new(SceneTextFile.NewScene, new("new scene.json", null, folders.Home));
        Selection = new(Document);
        Recovery = new(Document, folders, time);
        Gallery = new(folders, scenes);
        Files = new(Document, folders, Recovery, Gallery);
    }

    /// <summary>The document.</summary>
    public SceneDocument Document { get; }

    /// <summary>The selection.</summary>
    public Selection Selection { get; }

    /// <summary>Opens and saves it.</summary>
    public SceneFiles Files { get; }

    /// <summary>Texts that were not saved.</summary>
    public Recovery Recovery { get; }

    /// <summary>The shipped scenes.</summary>
    public Gallery Gallery { get; }

    /// <summary>Keeps what is not saved, and ends.</summary>
    public void Dispose()
    {
        Gallery.Dispose();
        Recovery.Dispose();
        Files.Uploads.Dispose();
        Document.Dispose();
    }
}
