using System.Text.Json;

namespace RayTracer.Session;

/// <summary>Views of a document to return to. Those of a saved one are kept for the next time; no scene's text knows them.</summary>
/// <param name="document">The document.</param>
/// <param name="view">The picture.</param>
/// <param name="folders">The folders in which they are kept.</param>
public sealed class ViewBookmarks(SceneDocument document, PictureView view, UserFolders folders)
{
    private const int Most = 100;
    private static readonly JsonSerializerOptions Format = new() { IncludeFields = true };
    private readonly Lock _lock = new();
    private Dictionary<string, List<ViewBookmark>>? _kept;

    /// <summary>Another view is kept, or one no longer.</summary>
    public event Action? Changed;

    /// <summary>Those of the document.</summary>
    public IReadOnlyList<ViewBookmark> All => _lock.Read(() => (IReadOnlyList<ViewBookmark>)[.. Here]);

    private string Key => document.Place.Path ?? document.Place.Name;

    private List<ViewBookmark> Here => (_kept ??= Load()).TryGetValue(Key, out List<ViewBookmark>? here) ? here : [];

    /// <summary>Keeps the view.</summary>
    /// <param name="name">Its name; null for a number.</param>
    /// <exception cref="SessionException">There is nothing to be seen, or there are too many.</exception>
    public void Add(string? name)
    {
        CameraPose pose = Precision.Round(view.RequireShown());
        lock (_lock)
        {
            List<ViewBookmark> here = Here;
            if (here.Count >= Most)
            {
                throw new SessionException($"No more than {Most} views of a scene are kept.");
            }

            int id = here.Count == 0 ? 1 : here.Max(b => b.Id) + 1;
            here.Add(new(id, string.IsNullOrWhiteSpace(name) ? SessionTexts.Of("viewport.bookmark", id) : name.Trim(), pose));
            _kept![Key] = here;
            Save();
        }

        Changed?.Invoke();
    }

    /// <summary>Forgets a view.</summary>
    /// <exception cref="SessionException">There is none.</exception>
    public void Remove(int id)
    {
        lock (_lock)
        {
            if (Here.RemoveAll(b => b.Id == id) == 0)
            {
                throw Missing();
            }

            Save();
        }

        Changed?.Invoke();
    }

    /// <summary>A view.</summary>
    /// <exception cref="SessionException">There is none.</exception>
    public CameraPose Pose(int id) => All.FirstOrDefault(b => b.Id == id)?.Pose ?? throw Missing();

    private static SessionException Missing() => new("There is no such view.", SessionFault.Missing);

    // That it cannot be kept is no reason to stop anything.
    private void Save()
    {
        try
        {
            Dictionary<string, List<ViewBookmark>> saved = _kept!.Where(k => Path.IsPathFullyQualified(k.Key) && k.Value.Count > 0).ToDictionary();
            PrivateFile.Write(folders.ViewsFile, JsonSerializer.SerializeToUtf8Bytes(saved, Format));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Then they are there as long as the session is.
        }
    }

    private Dictionary<string, List<ViewBookmark>> Load()
    {
        try
        {
            return JsonSerializer.Deserialize<Dictionary<string, List<ViewBookmark>>>(File.ReadAllBytes(folders.ViewsFile), Format) ?? [];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException)
        {
            return [];
        }
    }
}

/// <summary>A view that is kept.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Name">Its name.</param>
/// <param name="Pose">The camera.</param>
public sealed record ViewBookmark(int Id, string Name, CameraPose Pose);

/// <summary>Through which camera the picture is seen.</summary>
/// <param name="Pose">Its pose; null where there is nothing to be seen.</param>
/// <param name="IsSceneCamera">True for the scene's own.</param>
/// <param name="Picture">The picture's number: another one shows something else, or from elsewhere.</param>
/// <param name="Bookmarks">The views that are kept.</param>
public sealed record ViewStatus(CameraPose? Pose, bool IsSceneCamera, long Picture, IReadOnlyList<ViewBookmark> Bookmarks);
