-- | The options that say how finely a picture's file is coded.
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
    <$> setting (option wholeNumber (long "bits" <> metavar "N" <> help "Bits per primary: PNG 8 or 16, TIFF 16 or 32, OpenEXR 16 or 32"))
    <*> setting (option wholeNumber (long "quality" <> metavar "N" <> help "JPEG's quality, 1 to 100 (default: 92)"))
