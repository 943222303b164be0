using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>What was opened or saved lately.</summary>
/// <param name="choose">Asks for a file and opens it.</param>
/// <param name="open">Opens a file.</param>
internal sealed class FilesViewModel(Action choose, Action<string> open) : Observable
{
    private IReadOnlyList<RecentFile> _recent = [];

    /// <summary>The files, newest first.</summary>
    public IReadOnlyList<RecentFile> Recent
    {
        get => _recent;
        private set => Set(ref _recent, value);
    }

    /// <summary>Whether there are none.</summary>
    public bool IsEmpty => _recent.Count == 0;

    /// <summary>Asks for a file and opens it.</summary>
    public ICommand Choose { get; } = new ActionCommand(choose);

    /// <summary>Lists files.</summary>
    public void Show(IReadOnlyList<string> paths)
    {
        if (!paths.SequenceEqual(_recent.Select(r => r.Path)))
        {
            Recent = [.. paths.Select(p => new RecentFile(p, new ActionCommand(() => open(p))))];
            Tell(nameof(IsEmpty));
        }
    }
}

/// <summary>A file that was opened or saved lately.</summary>
/// <param name="Path">Its whole path.</param>
/// <param name="Open">Opens it.</param>
internal sealed record RecentFile(string Path, ICommand Open)
{
    /// <summary>Its name.</summary>
    public string Name => System.IO.Path.GetFileName(Path);
}
