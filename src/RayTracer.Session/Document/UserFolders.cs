namespace RayTracer.Session;

/// <summary>
/// The folders of a user in which a session keeps what is not the user's own work. Each is made when it is first needed, closed to other
/// users.
/// </summary>
/// <param name="state">The folder of what is to be kept: recovery, the list of recent files.</param>
/// <param name="cache">The folder of what can be made again, and of uploads.</param>
/// <param name="home">The folder that dialogs show first.</param>
public sealed class UserFolders(string state, string cache, string home)
{
    /// <summary>The folder in which dialogs begin.</summary>
    public string Home => home;

    /// <summary>Texts that were not saved.</summary>
    public string Recovery => Make(Path.Combine(state, "recovery"));

    /// <summary>Films of pictures that were not written to a file.</summary>
    public string RecoveredFilms => Make(Path.Combine(Recovery, "films"));

    /// <summary>The file that lists what was opened lately.</summary>
    public string RecentFile => Path.Combine(Make(state), "recent.json");

    /// <summary>The file of the views that are kept.</summary>
    public string ViewsFile => Path.Combine(Make(state), "views.json");

    /// <summary>The file that holds the port of the Studio's last server.</summary>
    public string PortFile => Path.Combine(Make(state), "port");

    /// <summary>Pictures of the gallery.</summary>
    public string Thumbnails => Make(Path.Combine(cache, "thumbnails"));

    /// <summary>Files that were dropped onto a window.</summary>
    public string Uploads => Make(Path.Combine(cache, "uploads"));

    /// <summary>The folders of the user who runs the program: of the XDG base directories, or where the system keeps such things.</summary>
    public static UserFolders OfUser()
    {
        string home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile);
        string local = Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData, Environment.SpecialFolderOption.DoNotVerify);
        string fallback = local.Length > 0 ? local : Path.GetTempPath();
        return new(Named("XDG_STATE_HOME") ?? Path.Combine(fallback, "raytracer"), Named("XDG_CACHE_HOME") ?? Path.Combine(fallback, "raytracer", "cache"), home);
    }

    /// <summary>Makes a folder that only its user may look into.</summary>
    public static string Make(string folder)
    {
        if (!Directory.Exists(folder))
        {
            if (OperatingSystem.IsWindows())
            {
                Directory.CreateDirectory(folder);
            }
            else
            {
                Directory.CreateDirectory(folder, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
            }
        }

        return folder;
    }

    private static string? Named(string variable) =>
        Environment.GetEnvironmentVariable(variable) is { Length: > 0 } folder && Path.IsPathFullyQualified(folder) ? Path.Combine(folder, "raytracer") : null;
}
