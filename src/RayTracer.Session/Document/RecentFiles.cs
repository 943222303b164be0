using System.Text.Json;

namespace RayTracer.Session;

/// <summary>The files that a user opened or saved last, newest first: one list for all Studios of the user.</summary>
/// <param name="folders">The folders in which the list is kept.</param>
public sealed class RecentFiles(UserFolders folders)
{
    private const int Most = 20;

    /// <summary>The whole paths of those that are still there.</summary>
    public IReadOnlyList<string> All => [.. Load().Where(File.Exists)];

    /// <summary>Puts a file at the top. That it cannot be kept is no reason to stop anything.</summary>
    public void Add(string path)
    {
        try
        {
            byte[] list = JsonSerializer.SerializeToUtf8Bytes(Load().Where(p => p != path).Prepend(path).Take(Most));
            PrivateFile.Write(folders.RecentFile, list);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The list is a convenience.
        }
    }

    private IReadOnlyList<string> Load()
    {
        try
        {
            return JsonSerializer.Deserialize<string[]>(File.ReadAllBytes(folders.RecentFile)) is { } paths ? [.. paths.OfType<string>()] : [];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException)
        {
            return [];
        }
    }
}
