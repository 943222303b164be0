using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A text, or the name of a file.</summary>
internal sealed class TextFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The text.</summary>
    public string Text
    {
        get => ParameterValues.Text(Effective) ?? "";
        set
        {
            if (value is not null && value != Text)
            {
                Write(value);
            }
        }
    }

    /// <summary>Whether it is a file.</summary>
    public bool IsFile => Parameter.Kind == "file";

    /// <summary>Asks for a file.</summary>
    public ICommand Choose => new ActionCommand(() => Context.ChooseFile(path => Write(path)));

    /// <inheritdoc/>
    protected override void Shown()
    {
    }
}
