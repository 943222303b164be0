namespace RayTracer.Desktop.ViewModels;

/// <summary>The services that only the system's window can give the view models.</summary>
internal interface IWindowServices
{
    /// <summary>Asks for a file to open; null where none was chosen.</summary>
    /// <param name="title">The dialog's title.</param>
    /// <param name="folder">The folder in which it begins; null for the system's choice.</param>
    /// <param name="extensions">The extensions that may be chosen, without dots.</param>
    Task<string?> ChooseFile(string title, string? folder, IReadOnlyList<string> extensions);

    /// <summary>
    /// Asks where to save; null where nothing was chosen. A file that exists is returned only after the user agreed to replace it.
    /// </summary>
    /// <param name="title">The dialog's title.</param>
    /// <param name="folder">The folder in which it begins; null for the system's choice.</param>
    /// <param name="name">The name that is offered.</param>
    Task<string?> ChooseNewFile(string title, string? folder, string name);

    /// <summary>Puts a text on the clipboard.</summary>
    Task CopyText(string text);

    /// <summary>Puts a picture on the clipboard.</summary>
    /// <param name="png">The picture as a PNG file.</param>
    Task CopyPicture(byte[] png);

    /// <summary>Closes the window, whatever is not saved.</summary>
    void Close();
}
