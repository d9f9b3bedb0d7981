-- | The options for the encoding of a picture's file.
module BlackHole.Cli.CodingOptions
  ( codingOptions,
  )
where

import BlackHole.Cli.Read
import BlackHole.Image.Coding (Coding (..))
import Options.Applicative

-- | @--bits@ and @--quality@.
codingOptions :: Parser Coding
codingOptions =
  Coding
    <$> setting
      ( option
          wholeNumber
          ( long "bits" <> metavar "N"
              <> help
                "Bits per colour channel: 8 or 16 for PNG, 16 or 32 for TIFF and OpenEXR (default: \
                \the smaller)"
          )
      )
    <*> setting
      ( option
          wholeNumber
          (long "quality" <> metavar "N" <> help "Quality of a JPEG, 1 to 100 (default: 92)")
      )
