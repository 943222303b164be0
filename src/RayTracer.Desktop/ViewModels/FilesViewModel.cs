using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The files that were opened or saved last.</summary>
/// <param name="choose">Asks for a file and opens it.</param>
/// <param name="open">Opens a file.</param>
internal sealed class FilesViewModel(Action choose, Action<string> open) : Observable
{
    /// <summary>The files, newest first.</summary>
    public IReadOnlyList<RecentFile> Recent { get; private set => SetProperty(ref field, value); } = [];

    public bool IsEmpty => Recent.Count == 0;

    /// <summary>Asks for a file and opens it.</summary>
    public ICommand Choose { get; } = new RelayCommand(choose);

    /// <summary>Lists files.</summary>
    public void Show(IReadOnlyList<string> paths)
    {
        if (!paths.SequenceEqual(Recent.Select(r => r.Path)))
        {
            Recent = [.. paths.Select(p => new RecentFile(p, new RelayCommand(() => open(p))))];
            OnPropertyChanged(nameof(IsEmpty));
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
